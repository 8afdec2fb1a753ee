package dev.cairn.core.user;

import dev.cairn.core.ecs.component.Component;

import java.util.List;

/** Records as users write them: in a package that is not the engine's. */
public final class UserRecords {
    record PackagePrivate(float x, boolean flag, String text) {}

    private record Private(double x) {}

    /**
     * A public one.
     *
     * @param x any number
     * @param names any names
     */
    public record Public(int x, List<String> names) {}

    /**
     * One whose field only this package can name.
     *
     * @param secret a class of this package
     */
    public record Secretive(PackagePrivate secret) {}

    private UserRecords() {}

    /**
     * Keys and samples.
     *
     * @return a value of each record
     */
    public static List<Record> all() {
        return List.of(
                new PackagePrivate(1.5f, true, "text"),
                new Private(2.5),
                new Public(3, List.of("a", "b")),
                new Secretive(new PackagePrivate(4, false, "inner")));
    }

    /**
     * A key that this package asks for itself.
     *
     * @return the key of the package-private record
     */
    public static Component<?> own() {
        return Component.of(PackagePrivate.class);
    }
}
