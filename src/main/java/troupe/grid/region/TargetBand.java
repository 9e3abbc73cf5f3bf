package troupe.grid.region;

import java.util.Arrays;
import troupe.grid.GridFrame;
import troupe.grid.region.crossing.Crossings;
import troupe.grid.region.ground.Words;

/**
 * Holds the legal neighbours of those configurations over a band of rows for which a mask of directions does
 * not say them all: some spans, and every crossing. They are found when the first of them is asked for. A band
 * may belong to several regions that do not differ in it and the bands beside it; so crossings are
 * counted from the first of their band. Safe for any thread.
 */
final class TargetBand {
    /** Rows of a band. */
    static final int ROWS = 8;

    private volatile Lists lists;

    /** Copies the neighbours of a special span of this band, or of a crossing; returns how many there are. */
    int of(int q, int band, Source source, int[] targets, int[] directions) {
        Lists known = lists;
        if (known == null) {
            synchronized (this) {
                if (lists == null) {
                    lists = new Lists(band, source);
                }
                known = lists;
            }
        }
        return known.of(q, band, source, targets, directions);
    }

    /** What the lists of a region's bands are made of: first crossings of each band and one more for the end. */
    record Source(
            Words words, Crossings crossings, int[] firstOfBand, Neighbours neighbours, GridFrame frame, int spans) {

        /** Counts where the crossings of each band begin. */
        static Source of(Words words, Crossings crossings, Neighbours neighbours, GridFrame frame, int spans) {
            int[] first = new int[bands(frame) + 1];
            for (int band = 0; band < first.length; band++) {
                first[band] = crossings.first(Math.min(frame.size(), band * ROWS * frame.cols()));
            }
            return new Source(words, crossings, first, neighbours, frame, spans);
        }
    }

    /** Returns how many bands a frame has. */
    static int bands(GridFrame frame) {
        return (frame.rows() + ROWS - 1) / ROWS;
    }

    /** The lists, one stretch of targets each: special spans by sheet and cell, then crossings. */
    private static final class Lists {
        private final int firstCell;
        private final int cells;
        private final long[] words;
        private final int[] before;
        private final int spans;
        private final int[] first;
        private int[] target;
        private byte[] direction;

        Lists(int band, Source source) {
            GridFrame frame = source.frame();
            this.firstCell = band * ROWS * frame.cols();
            this.cells = Math.min(ROWS * frame.cols(), frame.size() - firstCell);
            int sheets = source.spans() / frame.size();
            this.words = new long[(cells * sheets >> 6) + 1];
            this.before = new int[words.length];
            for (int sheet = 0; sheet < sheets; sheet++) {
                for (int i = 0; i < cells; i++) {
                    if ((source.words().get(sheet * frame.size() + firstCell + i) & Words.SPECIAL) != 0) {
                        words[sheet * cells + i >> 6] |= 1L << sheet * cells + i;
                    }
                }
            }
            for (int w = 1; w < words.length; w++) {
                before[w] = before[w - 1] + Long.bitCount(words[w - 1]);
            }
            this.spans = before[words.length - 1] + Long.bitCount(words[words.length - 1]);
            int crossings = source.firstOfBand()[band];
            int count = source.firstOfBand()[band + 1] - crossings;
            this.first = new int[spans + count + 1];
            this.target = new int[GridFrame.DIRECTIONS * first.length];
            this.direction = new byte[target.length];
            int[] targets = new int[Region.MAX_NEIGHBOURS];
            int[] directions = new int[Region.MAX_NEIGHBOURS];
            int slot = 0;
            for (int w = 0; w < words.length; w++) {
                for (long bits = words[w]; bits != 0; bits &= bits - 1) {
                    int i = (w << 6) + Long.numberOfTrailingZeros(bits);
                    int cell = firstCell + i % cells;
                    int q = i / cells * frame.size() + cell;
                    add(
                            slot++,
                            source.neighbours().of(q, cell, targets, directions),
                            targets,
                            directions,
                            band,
                            source);
                }
            }
            for (int i = crossings; i < crossings + count; i++) {
                int cell = source.crossings().cell(i);
                int n = source.neighbours().of(source.spans() + i, cell, targets, directions);
                add(slot++, n, targets, directions, band, source);
            }
            this.target = Arrays.copyOf(target, first[slot]);
            this.direction = Arrays.copyOf(direction, first[slot]);
        }

        private void add(int slot, int count, int[] targets, int[] directions, int band, Source source) {
            int from = first[slot];
            if (from + count > target.length) {
                target = Arrays.copyOf(target, 2 * target.length + count);
                direction = Arrays.copyOf(direction, target.length);
            }
            for (int k = 0; k < count; k++) {
                target[from + k] = packed(targets[k], band, source);
                direction[from + k] = (byte) directions[k];
            }
            first[slot + 1] = from + count;
        }

        /** Returns a span as it is, a crossing as the band it lies in and its number there, below 0. */
        private static int packed(int target, int band, Source source) {
            int crossing = target - source.spans();
            if (crossing < 0) {
                return target;
            }
            int in = band - 1;
            while (source.firstOfBand()[in + 1] <= crossing) {
                in++;
            }
            return ~(crossing - source.firstOfBand()[in] << 2 | in - band + 1);
        }

        int of(int q, int band, Source source, int[] targets, int[] directions) {
            int[] firstOfBand = source.firstOfBand();
            int slot = q < source.spans() ? rank(q, source.frame()) : spans + q - source.spans() - firstOfBand[band];
            int from = first[slot];
            int count = first[slot + 1] - from;
            for (int k = 0; k < count; k++) {
                int packed = target[from + k];
                targets[k] =
                        packed >= 0 ? packed : source.spans() + (~packed >> 2) + firstOfBand[band - 1 + (~packed & 3)];
                directions[k] = direction[from + k];
            }
            return count;
        }

        private int rank(int q, GridFrame frame) {
            int sheet = q / frame.size();
            int i = sheet * cells + q - sheet * frame.size() - firstCell;
            return before[i >> 6] + Long.bitCount(words[i >> 6] & (1L << i) - 1);
        }
    }
}
