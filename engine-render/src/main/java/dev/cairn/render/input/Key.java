package dev.cairn.render.input;

import org.jspecify.annotations.Nullable;

import java.util.Locale;

/**
 * A key that a function can be bound to, by its place on a US keyboard, so that W A S D keep their
 * places on other layouts. The codes are GLFW's ("Keyboard key tokens" of its manual).
 */
public enum Key implements Trigger {
    /** The key space. */
    SPACE(32),
    /** The key apostrophe. */
    APOSTROPHE(39),
    /** The key comma. */
    COMMA(44),
    /** The key minus. */
    MINUS(45),
    /** The key period. */
    PERIOD(46),
    /** The key slash. */
    SLASH(47),
    /** The key digit 0. */
    DIGIT_0(48),
    /** The key digit 1. */
    DIGIT_1(49),
    /** The key digit 2. */
    DIGIT_2(50),
    /** The key digit 3. */
    DIGIT_3(51),
    /** The key digit 4. */
    DIGIT_4(52),
    /** The key digit 5. */
    DIGIT_5(53),
    /** The key digit 6. */
    DIGIT_6(54),
    /** The key digit 7. */
    DIGIT_7(55),
    /** The key digit 8. */
    DIGIT_8(56),
    /** The key digit 9. */
    DIGIT_9(57),
    /** The key semicolon. */
    SEMICOLON(59),
    /** The key equal. */
    EQUAL(61),
    /** The key A. */
    A(65),
    /** The key B. */
    B(66),
    /** The key C. */
    C(67),
    /** The key D. */
    D(68),
    /** The key E. */
    E(69),
    /** The key F. */
    F(70),
    /** The key G. */
    G(71),
    /** The key H. */
    H(72),
    /** The key I. */
    I(73),
    /** The key J. */
    J(74),
    /** The key K. */
    K(75),
    /** The key L. */
    L(76),
    /** The key M. */
    M(77),
    /** The key N. */
    N(78),
    /** The key O. */
    O(79),
    /** The key P. */
    P(80),
    /** The key Q. */
    Q(81),
    /** The key R. */
    R(82),
    /** The key S. */
    S(83),
    /** The key T. */
    T(84),
    /** The key U. */
    U(85),
    /** The key V. */
    V(86),
    /** The key W. */
    W(87),
    /** The key X. */
    X(88),
    /** The key Y. */
    Y(89),
    /** The key Z. */
    Z(90),
    /** The key left bracket. */
    LEFT_BRACKET(91),
    /** The key backslash. */
    BACKSLASH(92),
    /** The key right bracket. */
    RIGHT_BRACKET(93),
    /** The key grave accent. */
    GRAVE_ACCENT(96),
    /** The first key that only non-US keyboards have. */
    WORLD_1(161),
    /** The second key that only non-US keyboards have. */
    WORLD_2(162),
    /** The key escape. */
    ESCAPE(256),
    /** The key enter. */
    ENTER(257),
    /** The key tab. */
    TAB(258),
    /** The key backspace. */
    BACKSPACE(259),
    /** The key insert. */
    INSERT(260),
    /** The key delete. */
    DELETE(261),
    /** The key right. */
    RIGHT(262),
    /** The key left. */
    LEFT(263),
    /** The key down. */
    DOWN(264),
    /** The key up. */
    UP(265),
    /** The key page up. */
    PAGE_UP(266),
    /** The key page down. */
    PAGE_DOWN(267),
    /** The key home. */
    HOME(268),
    /** The key end. */
    END(269),
    /** The key caps lock. */
    CAPS_LOCK(280),
    /** The key scroll lock. */
    SCROLL_LOCK(281),
    /** The key num lock. */
    NUM_LOCK(282),
    /** The key print screen. */
    PRINT_SCREEN(283),
    /** The key pause. */
    PAUSE(284),
    /** The key f1. */
    F1(290),
    /** The key f2. */
    F2(291),
    /** The key f3. */
    F3(292),
    /** The key f4. */
    F4(293),
    /** The key f5. */
    F5(294),
    /** The key f6. */
    F6(295),
    /** The key f7. */
    F7(296),
    /** The key f8. */
    F8(297),
    /** The key f9. */
    F9(298),
    /** The key f10. */
    F10(299),
    /** The key f11. */
    F11(300),
    /** The key f12. */
    F12(301),
    /** The key f13. */
    F13(302),
    /** The key f14. */
    F14(303),
    /** The key f15. */
    F15(304),
    /** The key f16. */
    F16(305),
    /** The key f17. */
    F17(306),
    /** The key f18. */
    F18(307),
    /** The key f19. */
    F19(308),
    /** The key f20. */
    F20(309),
    /** The key f21. */
    F21(310),
    /** The key f22. */
    F22(311),
    /** The key f23. */
    F23(312),
    /** The key f24. */
    F24(313),
    /** The key f25. */
    F25(314),
    /** The key keypad 0. */
    KEYPAD_0(320),
    /** The key keypad 1. */
    KEYPAD_1(321),
    /** The key keypad 2. */
    KEYPAD_2(322),
    /** The key keypad 3. */
    KEYPAD_3(323),
    /** The key keypad 4. */
    KEYPAD_4(324),
    /** The key keypad 5. */
    KEYPAD_5(325),
    /** The key keypad 6. */
    KEYPAD_6(326),
    /** The key keypad 7. */
    KEYPAD_7(327),
    /** The key keypad 8. */
    KEYPAD_8(328),
    /** The key keypad 9. */
    KEYPAD_9(329),
    /** The key keypad decimal. */
    KEYPAD_DECIMAL(330),
    /** The key keypad divide. */
    KEYPAD_DIVIDE(331),
    /** The key keypad multiply. */
    KEYPAD_MULTIPLY(332),
    /** The key keypad subtract. */
    KEYPAD_SUBTRACT(333),
    /** The key keypad add. */
    KEYPAD_ADD(334),
    /** The key keypad enter. */
    KEYPAD_ENTER(335),
    /** The key keypad equal. */
    KEYPAD_EQUAL(336),
    /** The key left shift. */
    LEFT_SHIFT(340),
    /** The key left control. */
    LEFT_CONTROL(341),
    /** The key left alt. */
    LEFT_ALT(342),
    /** The key left super. */
    LEFT_SUPER(343),
    /** The key right shift. */
    RIGHT_SHIFT(344),
    /** The key right control. */
    RIGHT_CONTROL(345),
    /** The key right alt. */
    RIGHT_ALT(346),
    /** The key right super. */
    RIGHT_SUPER(347),
    /** The key menu. */
    MENU(348);

    private static final int LIMIT = 349;
    private static final @Nullable Key[] BY_CODE = new Key[LIMIT];

    static {
        for (Key key : values()) {
            BY_CODE[key.code] = key;
        }
    }

    private final int code;
    private final String label;

    Key(int code) {
        this.code = code;
        this.label = labelOf(name());
    }

    private static String labelOf(String name) {
        return switch (name) {
            case "ESCAPE" -> "Esc";
            case "LEFT_BRACKET" -> "[";
            case "RIGHT_BRACKET" -> "]";
            case "BACKSLASH" -> "\\";
            case "LEFT_SHIFT" -> "Shift";
            case "LEFT_CONTROL" -> "Ctrl";
            case "LEFT_ALT" -> "Alt";
            case "LEFT" -> "Left arrow";
            case "RIGHT" -> "Right arrow";
            case "UP" -> "Up arrow";
            case "DOWN" -> "Down arrow";
            default -> {
                String words = name.startsWith("DIGIT_") ? name.substring(6) : name;
                yield words.charAt(0)
                        + words.substring(1).replace('_', ' ').toLowerCase(Locale.ROOT);
            }
        };
    }

    /** The key of that constant name, or null. */
    static @Nullable Key named(String name) {
        for (Key key : values()) {
            if (key.name().equals(name)) {
                return key;
            }
        }
        return null;
    }

    @Override
    public String label() {
        return label;
    }

    @Override
    public String id() {
        return name();
    }

    /**
     * GLFW's number of this key.
     *
     * @return 32..348
     */
    public int code() {
        return code;
    }

    /**
     * The key of GLFW's number.
     *
     * @param code the number that a key callback gave
     * @return the key, or null if GLFW does not know it
     */
    public static @Nullable Key ofCode(int code) {
        return code < 0 || code >= LIMIT ? null : BY_CODE[code];
    }
}
