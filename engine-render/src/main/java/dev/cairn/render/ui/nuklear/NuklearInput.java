package dev.cairn.render.ui.nuklear;

import static org.lwjgl.nuklear.Nuklear.*;

import dev.cairn.render.input.Key;
import dev.cairn.render.input.MouseButton;

import org.lwjgl.nuklear.NkContext;
import org.lwjgl.nuklear.NkVec2;

import java.util.Arrays;

/** Keyboard and mouse of the panels: {@link #begin}, events, {@link #end}, once a frame. */
public final class NuklearInput {
    private final NkContext context;
    private final NkVec2 vector;
    private double cursorX;

    /** Whether a button was pressed or let go in this frame, and the cursor went on after that. */
    private boolean clicked;

    private boolean wentOn;
    private double laterX;
    private double laterY;
    private boolean leftDown;
    private boolean leftPressed;

    /** Keys and letters that come in a later frame, in their order. */
    private int[] waiting = new int[64];

    private int waitingCount;

    /** Bit by bit the keys that Nuklear has as down. */
    private long down;

    private int letterBytes;
    private boolean keyed;

    /** Whether an event came since the last frame that may change what panels show. */
    private boolean stirred = true;

    /** Whether the left button went down over a panel, and is down. */
    private boolean holding;

    NuklearInput(NkContext context, NkVec2 vector) {
        this.context = context;
        this.vector = vector;
    }

    /** Begins to take events. */
    public void begin() {
        leftPressed = false;
        clicked = false;
        letterBytes = 0;
        keyed = false;
        nk_input_begin(context);
        stirred |= wentOn || waitingCount > 0;
        if (wentOn) {
            wentOn = false;
            moved(laterX, laterY);
        }
        int taken = 0;
        while (taken < waitingCount && take(waiting[taken])) {
            taken++;
        }
        waitingCount -= taken;
        System.arraycopy(waiting, taken, waiting, 0, waitingCount);
    }

    /** Ends to take events. */
    public void end() {
        nk_input_end(context);
    }

    /**
     * The cursor moved. After a click in the same frame this waits for the next one, since Nuklear
     * knows one place a frame: else a quick click in a slow frame would hit what lies elsewhere.
     *
     * @param x real pixels from the left
     * @param y real pixels from above
     */
    public void moved(double x, double y) {
        if (clicked) {
            wentOn = true;
            laterX = x;
            laterY = y;
            return;
        }
        cursorX = x;
        boolean wasOver = nk_window_is_any_hovered(context);
        nk_input_motion(context, (int) x, (int) y);
        stirred |= holding || wasOver || nk_window_is_any_hovered(context);
    }

    /**
     * A mouse button went down or up.
     *
     * @param which the button
     * @param x cursor, real pixels
     * @param y cursor, real pixels
     * @param down whether it went down
     */
    public void button(MouseButton which, double x, double y, boolean down) {
        if (which == MouseButton.LEFT) {
            cursorX = x;
            leftDown = down;
            leftPressed |= down;
            holding = down && nk_window_is_any_hovered(context);
        }
        clicked = true;
        stirred = true;
        int code =
                switch (which) {
                    case LEFT -> NK_BUTTON_LEFT;
                    case RIGHT -> NK_BUTTON_RIGHT;
                    case MIDDLE -> NK_BUTTON_MIDDLE;
                    default -> -1;
                };
        if (code >= 0) {
            nk_input_button(context, code, (int) x, (int) y, down);
        }
    }

    /**
     * The wheel turned.
     *
     * @param steps away from the user
     */
    public void scrolled(double steps) {
        stirred = true;
        nk_input_scroll(context, vector.set(0, (float) steps));
    }

    /**
     * A letter was typed.
     *
     * @param codePoint Unicode; control characters are no letters
     */
    public void typed(int codePoint) {
        if (!Character.isISOControl(codePoint)) {
            offer(codePoint);
        }
    }

    /**
     * Nuklear takes letters before keys, a key once, and 15 bytes of letters a frame: the rest
     * waits, so that in slow frames nothing is lost and nothing overtakes.
     */
    private void offer(int event) {
        stirred = true;
        if (waitingCount == 0 && take(event)) {
            return;
        }
        if (waitingCount == waiting.length) {
            waiting = Arrays.copyOf(waiting, 2 * waitingCount);
        }
        waiting[waitingCount++] = event;
    }

    /** Letters are their code points, keys are negative: -1 - (2 code + 1 if down). */
    private boolean take(int event) {
        if (event >= 0) {
            int bytes = event < 0x80 ? 1 : event < 0x800 ? 2 : event < 0x10000 ? 3 : 4;
            if (keyed || letterBytes + bytes >= NK_INPUT_MAX) {
                return false;
            }
            letterBytes += bytes;
            nk_input_unicode(context, event);
            return true;
        }
        int code = (-1 - event) >> 1;
        boolean isDown = ((-1 - event) & 1) != 0;
        boolean shift = code == NK_KEY_SHIFT;
        if ((shift || isDown) && (keyed || (!shift && letterBytes > 0))) {
            return false;
        }
        boolean repeats = isDown && (down >>> code & 1) != 0;
        if (repeats) {
            nk_input_key(context, code, false);
        }
        nk_input_key(context, code, isDown);
        down = isDown ? down | 1L << code : down & ~(1L << code);
        keyed |= isDown && !shift;
        return true;
    }

    /** Whether something that was typed comes in a later frame. */
    boolean isWaiting() {
        return waitingCount > 0;
    }

    /**
     * A key went down (or repeats), or up.
     *
     * @param key the key
     * @param isDown whether it went down
     * @param control whether control is held
     */
    public void key(Key key, boolean isDown, boolean control) {
        int code =
                switch (key) {
                    case BACKSPACE -> NK_KEY_BACKSPACE;
                    case DELETE -> NK_KEY_DEL;
                    case ENTER, KEYPAD_ENTER -> NK_KEY_ENTER;
                    case TAB -> NK_KEY_TAB;
                    case LEFT -> control ? NK_KEY_TEXT_WORD_LEFT : NK_KEY_LEFT;
                    case RIGHT -> control ? NK_KEY_TEXT_WORD_RIGHT : NK_KEY_RIGHT;
                    case UP -> NK_KEY_UP;
                    case DOWN -> NK_KEY_DOWN;
                    case HOME -> NK_KEY_TEXT_LINE_START;
                    case END -> NK_KEY_TEXT_LINE_END;
                    case LEFT_SHIFT, RIGHT_SHIFT -> NK_KEY_SHIFT;
                    case A -> control ? NK_KEY_TEXT_SELECT_ALL : NK_KEY_NONE;
                    case C -> control ? NK_KEY_COPY : NK_KEY_NONE;
                    case V -> control ? NK_KEY_PASTE : NK_KEY_NONE;
                    case X -> control ? NK_KEY_CUT : NK_KEY_NONE;
                    case ESCAPE -> NK_KEY_TEXT_RESET_MODE;
                    default -> NK_KEY_NONE;
                };
        if (code != NK_KEY_NONE) {
            offer(-1 - (2 * code + (isDown ? 1 : 0)));
        }
    }

    /** Something happened that is no event of the panels, and may change what they show. */
    public void stir() {
        stirred = true;
    }

    /** Whether something happened since the last call. */
    boolean wasStirred() {
        boolean was = stirred;
        stirred = false;
        return was;
    }

    /** Where the cursor is, real pixels. */
    double cursorX() {
        return cursorX;
    }

    /** Whether the left button is down, or was in this frame. */
    boolean isDragging() {
        return leftDown || leftPressed;
    }

    /** Whether the left button went down in this frame. */
    boolean wasPressed() {
        return leftPressed;
    }
}
