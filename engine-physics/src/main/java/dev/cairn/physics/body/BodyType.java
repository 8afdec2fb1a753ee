package dev.cairn.physics.body;

/** What moves a body. */
public enum BodyType {
    /** Nothing; see {@link dev.cairn.physics.Body#fixed}. */
    FIXED,

    /**
     * The user, by a velocity or a target; nothing else; see {@link
     * dev.cairn.physics.Body#kinematic}.
     */
    KINEMATIC,

    /** Forces and contacts; see {@link dev.cairn.physics.Body#dynamic}. */
    DYNAMIC
}
