package dev.cairn.physics;

/** What moves a body. */
public enum BodyType {
    /** Nothing; see {@link Body#fixed}. */
    FIXED,

    /** The user, by a velocity or a target; nothing else; see {@link Body#kinematic}. */
    KINEMATIC,

    /** Forces and contacts; see {@link Body#dynamic}. */
    DYNAMIC
}
