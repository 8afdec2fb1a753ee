package dev.cairn.system;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.core.importer.Location;

import java.util.regex.Pattern;

/** What ships: neither tests nor benchmarks, whether Maven or plain javac compiled them. */
final class ShippedClasses implements ImportOption {
    private static final Pattern OTHERS =
            Pattern.compile(".*/(test-classes|t-[a-z]+|benchmarks)/.*");

    @Override
    public boolean includes(Location location) {
        return !location.matches(OTHERS);
    }
}
