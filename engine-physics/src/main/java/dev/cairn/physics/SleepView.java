package dev.cairn.physics;

import dev.cairn.physics.island.SleepChanges;

import java.util.Arrays;
import java.util.Objects;

/** The façade of sleep events: references, so that they outlive the bodies. */
final class SleepView implements SleepEvents {
    private final BodyTable table;
    private BodyRef[] fell = new BodyRef[32];
    private int fellCount;
    private BodyRef[] woke = new BodyRef[32];
    private int wokeCount;

    SleepView(BodyTable table) {
        this.table = table;
    }

    /** At the end of a step. */
    void update() {
        table.sleepers.told().tell();
        show();
    }

    /** The events of the last tick. */
    void show() {
        SleepChanges s = table.sleepers.told();
        fellCount = s.fellCount();
        wokeCount = s.wokeCount();
        if (fell.length < fellCount) {
            fell = Arrays.copyOf(fell, fellCount + (fellCount >> 1));
        }
        if (woke.length < wokeCount) {
            woke = Arrays.copyOf(woke, wokeCount + (wokeCount >> 1));
        }
        for (int i = 0; i < fellCount; i++) {
            fell[i] = table.refs[s.fell(i)];
        }
        for (int i = 0; i < wokeCount; i++) {
            woke[i] = table.refs[s.woke(i)];
        }
    }

    @Override
    public int fellAsleepCount() {
        return fellCount;
    }

    @Override
    public BodyRef fellAsleep(int event) {
        return fell[Objects.checkIndex(event, fellCount)];
    }

    @Override
    public int wokeCount() {
        return wokeCount;
    }

    @Override
    public BodyRef woke(int event) {
        return woke[Objects.checkIndex(event, wokeCount)];
    }

    @Override
    public int asleepCount() {
        return table.sleepers.asleepCount();
    }
}
