package dev.cairn.core.job;

/**
 * The cut of {@code items} into blocks of a fixed size, the last one shorter. The cut depends on
 * counts only, never on the number of workers; so does everything that is merged in block order.
 *
 * <p>Static and without state; does not allocate.
 */
public final class Blocks {

    private Blocks() {}

    /**
     * Number of blocks.
     *
     * @param items number of items, at least 0
     * @param itemsPerBlock items per block, at least 1
     * @return {@code items / itemsPerBlock}, rounded up
     * @throws IllegalArgumentException if an argument is below its bound
     */
    public static int count(int items, int itemsPerBlock) {
        if (items < 0) {
            throw new IllegalArgumentException("items is " + items + ", but must be at least 0");
        }
        if (itemsPerBlock < 1) {
            throw new IllegalArgumentException(
                    "itemsPerBlock is " + itemsPerBlock + ", but must be at least 1");
        }
        return items == 0 ? 0 : (items - 1) / itemsPerBlock + 1;
    }

    /**
     * First item of a block.
     *
     * @param block the block, in {@code [0, count)}
     * @param itemsPerBlock items per block, as given to {@link #count}
     * @return index of the first item of the block
     */
    public static int begin(int block, int itemsPerBlock) {
        return block * itemsPerBlock;
    }

    /**
     * End of a block.
     *
     * @param block the block, in {@code [0, count)}
     * @param itemsPerBlock items per block, as given to {@link #count}
     * @param items number of items, as given to {@link #count}
     * @return one past the last item of the block
     */
    public static int end(int block, int itemsPerBlock, int items) {
        int begin = block * itemsPerBlock;
        return items - begin < itemsPerBlock ? items : begin + itemsPerBlock;
    }
}
