package dev.cairn.benchmarks.peer;

import dev.cairn.physics.tuning.Precision;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** The engines that can be compared. */
public enum Engine {
    /** This engine. */
    CAIRN("Cairn", "this build", "double, pure Java", 256, "sub-steps of the solver"),
    /** This engine with contacts in single precision. */
    CAIRN_SINGLE(
            "Cairn single",
            "this build, Precision.SINGLE",
            "float contacts, double bodies, pure Java",
            256,
            "sub-steps of the solver"),
    /** Jolt by way of jolt-jni. */
    JOLT(
            "Jolt",
            "jolt-jni 0.9.9",
            "float, C++ by JNI, ReleaseSp",
            256,
            "collision steps of one update"),
    /** Bullet by way of Libbulletjme. */
    BULLET(
            "Bullet",
            "Libbulletjme 23.1.0",
            "float, C++ by JNI, SpRelease",
            1,
            "updates of 1/(60 N) s"),
    /** PhysX by way of physx-jni. */
    PHYSX(
            "PhysX",
            "physx-jni 2.4.1 (PhysX 5.4.1)",
            "float, C++ by JNI, CPU",
            256,
            "steps of 1/(60 N) s"),
    /** The Java port of ODE. */
    ODE4J("ode4j", "0.5.3", "double, pure Java", 1, "quick steps of 1/(60 N) s"),
    /** The Java port of Bullet 2.72. */
    JBULLET("JBullet", "20101010-1", "float, pure Java", 1, "steps of 1/(60 N) s"),
    /** Box3D from a shared library that the user names. */
    BOX3D("Box3D", "0.2.0", "float, C by java.lang.foreign", 64, "sub-steps of one step");

    private final String title;
    private final String version;
    private final String kind;
    private final int maxWorkers;
    private final String knob;

    Engine(String title, String version, String kind, int maxWorkers, String knob) {
        this.title = title;
        this.version = version;
        this.kind = kind;
        this.maxWorkers = maxWorkers;
        this.knob = knob;
    }

    /**
     * The name on the command line.
     *
     * @return lower case
     */
    public String id() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /**
     * The name in the report.
     *
     * @return the engine's own spelling
     */
    public String title() {
        return title;
    }

    /**
     * The artifact and its version.
     *
     * @return a few words
     */
    public String version() {
        return version;
    }

    /**
     * Precision, language, build.
     *
     * @return a few words
     */
    public String kind() {
        return kind;
    }

    /**
     * Says whether it runs in the JVM, whose compiler needs a while.
     *
     * @return false for native code
     */
    public boolean isJava() {
        return isCairn() || this == ODE4J || this == JBULLET;
    }

    /**
     * Says whether it is this engine, in either precision.
     *
     * @return false for all others
     */
    public boolean isCairn() {
        return this == CAIRN || this == CAIRN_SINGLE;
    }

    /**
     * How many threads the build of the engine that is used here can step with.
     *
     * @return at least 1
     */
    public int maxWorkers() {
        return maxWorkers;
    }

    /**
     * What the number of sub-steps means to it.
     *
     * @return a few words
     */
    public String knob() {
        return knob;
    }

    /**
     * The engines that are there without further ado: all, but Box3D only where its library is
     * named.
     *
     * @return in the order of the report
     */
    public static List<Engine> available() {
        List<Engine> engines = new ArrayList<>(List.of(values()));
        if (System.getProperty(Box3dPeer.LIBRARY) == null) {
            engines.remove(BOX3D);
        }
        return engines;
    }

    /**
     * Says whether the engine documents settings for accuracy besides sub-steps.
     *
     * @return false if its best effort is its default
     */
    public boolean hasBest() {
        return !isCairn() && this != BOX3D;
    }

    /**
     * Says whether the number of iterations of its solver can be set.
     *
     * @return false where a sub-step is one sweep
     */
    public boolean hasIterations() {
        return !isCairn() && this != BOX3D;
    }

    /**
     * Says whether contacts are found once a tick, whatever the number of sub-steps, and this can
     * be refined.
     *
     * @return false where each sub-step is a whole step
     */
    public boolean collidesOncePerTick() {
        return isCairn();
    }

    /**
     * Finds an engine.
     *
     * @param id its name, any case
     * @return the engine
     * @throws IllegalArgumentException if there is none; the message lists all
     */
    public static Engine of(String id) {
        List<String> known = new ArrayList<>();
        for (Engine engine : values()) {
            if (engine.id().equals(id.toLowerCase(Locale.ROOT))) {
                return engine;
            }
            known.add(engine.id());
        }
        throw new IllegalArgumentException(
                "engine \"%s\": there is none; known are %s"
                        .formatted(id, String.join(", ", known)));
    }

    /**
     * Builds a scene in this engine.
     *
     * @param scene what to build
     * @param settings how to run it
     * @return the live scene, before its first tick
     * @throws MissingEngineException if the engine's classes or natives are not there
     * @throws IllegalArgumentException if the engine cannot hold the scene; the message says why
     */
    public Peer create(SceneDescription scene, PeerSettings settings) {
        if (settings.workers() > maxWorkers) {
            throw new IllegalArgumentException(
                    "%s: this build steps with at most %d worker(s)".formatted(title, maxWorkers));
        }
        try {
            return switch (this) {
                case CAIRN -> new CairnPeer(scene, settings, Precision.AUTO);
                case CAIRN_SINGLE -> new CairnPeer(scene, settings, Precision.SINGLE);
                case JOLT -> new JoltPeer(scene, settings);
                case BULLET -> new BulletPeer(scene, settings);
                case PHYSX -> new PhysxPeer(scene, settings);
                case ODE4J -> new OdePeer(scene, settings);
                case JBULLET -> new JBulletPeer(scene, settings);
                case BOX3D -> new Box3dPeer(scene, settings);
            };
        } catch (LinkageError absent) {
            throw new MissingEngineException(title + " cannot be loaded: " + absent, absent);
        }
    }
}
