package dev.cairn.render.app;

import dev.cairn.physics.PhysicsWorld;

/** What the simulation thread asks of an application. */
final class ApplicationHost implements Simulation.Host {
    private final Application application;

    ApplicationHost(Application application) {
        this.application = application;
    }

    @Override
    public PhysicsWorld createPhysics() {
        return application.createPhysics();
    }

    @Override
    public void begin(PhysicsWorld physics) {
        Scene filled =
                new Scene(
                        physics,
                        application.camera(),
                        application.bindings(),
                        application.getClass().getSimpleName());
        application.scene(filled);
        application.initScene(filled);
        filled.mountCamera();
    }

    @Override
    public void update(double seconds) {
        application.scene().drive(seconds);
        application.update(seconds);
        application.bindings().endTick(); // update is the last that may ask what was pressed
    }

    @Override
    public void updated(double seconds) {
        application.updated(seconds);
    }

    @Override
    public boolean beginsAgainAfter(RuntimeException failure) {
        return application.scene().beginsAgainAfter(failure);
    }

    /** Runs all ticks; false if this thread was interrupted meanwhile. */
    static boolean runToEnd(Simulation running) {
        running.start();
        try {
            running.await();
            return true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            running.stop();
            return false;
        }
    }
}
