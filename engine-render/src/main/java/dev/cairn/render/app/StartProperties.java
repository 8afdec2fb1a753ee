package dev.cairn.render.app;

import dev.cairn.render.camera.Effects;

import java.nio.file.Path;
import java.util.Locale;

/** What system properties and the environment say before an application starts. Main thread. */
final class StartProperties {
    private StartProperties() {}

    /** Does what the properties ask for. */
    static void read(Application application) {
        String size = System.getProperty("cairn.size");
        if (size != null) {
            String[] parts = size.split("x", -1);
            if (parts.length != 2) {
                throw new IllegalArgumentException(
                        "cairn.size is '" + size + "', expected WIDTHxHEIGHT such as 1280x720");
            }
            application.size(
                    (int) number("cairn.size", parts[0]), (int) number("cairn.size", parts[1]));
        }
        String scale = System.getProperty("cairn.ui.scale");
        if (scale != null) {
            try {
                application.panelScale(Double.parseDouble(scale));
            } catch (NumberFormatException e) {
                throw new IllegalArgumentException(
                        "cairn.ui.scale holds '" + scale + "', expected a number", e);
            }
        }
        Effects effects = Effects.ofProperty();
        if (effects != null) {
            application.effects(effects);
        }
        String tick = System.getProperty("cairn.tick");
        if (tick != null) {
            application.pictureTick(number("cairn.tick", tick));
        }
        String file = System.getProperty("cairn.picture");
        if (file != null) {
            application.headless(Path.of(file), application.pictureTick());
        }
    }

    private static long number(String property, String text) {
        try {
            return Math.max(0, Long.parseLong(text.strip()));
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    property + " holds '" + text + "', expected a whole number", e);
        }
    }

    /** X11 and Wayland name their display; macOS and Windows have one. */
    static boolean hasDisplay() {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        if (system.contains("win") || system.contains("mac")) {
            return true;
        }
        return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
    }

    private static boolean isSet(String variable) {
        String value = System.getenv(variable);
        return value != null && !value.isBlank();
    }
}
