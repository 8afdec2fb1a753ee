package dev.cairn.samples.scenefile;

/** What part an entity has in the physics. */
public enum BodyKind {
    /** Forces and contacts move it. */
    DYNAMIC("dynamic"),
    /** Others collide with it, nothing moves it. */
    FIXED("fixed"),
    /** It is only drawn. */
    NONE("none"),
    /** It moves with its velocity, and nothing stops it. */
    KINEMATIC("kinematic");

    private final String word;

    BodyKind(String word) {
        this.word = word;
    }

    /**
     * The word in the file.
     *
     * @return lower case
     */
    public String word() {
        return word;
    }
}
