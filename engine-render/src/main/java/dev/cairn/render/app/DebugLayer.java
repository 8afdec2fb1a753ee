package dev.cairn.render.app;

/** What can be drawn over the scene to explain it; see {@link Application#debug}. */
public enum DebugLayer {
    /** Contact points: yellow, red where the bodies overlap. */
    CONTACTS("contact points", 1),
    /** Contact normals, 0.25 m long, from the first body to the second. */
    NORMALS("normals", 2),
    /** Arrows: how hard bodies push each other, on the second one; the largest is 1 m long. */
    IMPULSES("contact forces", 4),
    /** The boxes by which the broad phase finds neighbours, margin included. */
    BOXES("search boxes", 8),
    /** Velocities: where the centre of mass would be in a quarter of a second. */
    VELOCITIES("velocities", 16),
    /** Centres of mass. */
    CENTRES("centres of mass", 32),
    /** Bodies that sleep are blue. */
    SLEEP("colour: sleep", 64),
    /** Bodies that hang together by contacts have one colour, and are joined by lines of it. */
    ISLANDS("colour: island", 128),
    /** The constraint graph: a line for each contact, in the colour in which it is solved. */
    COLOURS("order of solving", 256),
    /**
     * Joints: from the centres of mass to the joint's points, its axis, and its limits as a
     * segment, an arc or a cone with where it stands; grey where it is off.
     */
    JOINTS("joints, limits", 512),
    /** Forces of joints on the second body, and torques; the largest of each is 1 m long. */
    JOINT_FORCES("joint forces", 1024),
    /** Bodies from blue (at rest) over white (3 m/s) to red. */
    SPEED("colour: speed", 2048),
    /** Bodies from blue to red by how hard contacts push them; red is who is pushed most. */
    LOAD("colour: load", 4096);

    private final String title;
    private final int bit;

    DebugLayer(String title, int bit) {
        this.title = title;
        this.bit = bit;
    }

    /**
     * A few words for a list.
     *
     * @return the title
     */
    public String title() {
        return title;
    }

    int bit() {
        return bit;
    }
}
