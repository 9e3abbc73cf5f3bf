package troupe.risk.plan;

import java.util.Arrays;

/** Maps states, longs from 0, to labels: open addressing, emptied in no time by a new stamp. Grows; never shrinks. */
final class StateTable {
    static final int NONE = -1;

    private long[] keys = new long[1 << 14];
    private int[] values = new int[keys.length];
    private int[] stamps = new int[keys.length];
    private int stamp = 1;
    private int size;

    void clear() {
        size = 0;
        if (++stamp == 0) {
            Arrays.fill(stamps, 0);
            stamp = 1;
        }
    }

    private static int spread(long key) {
        long mixed = key * 0x9E3779B97F4A7C15L;
        return (int) (mixed ^ mixed >>> 32);
    }

    private int slot(long key) {
        int mask = keys.length - 1;
        int slot = spread(key) & mask;
        while (stamps[slot] == stamp && keys[slot] != key) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    int get(long key) {
        int slot = slot(key);
        return stamps[slot] == stamp ? values[slot] : NONE;
    }

    void put(long key, int value) {
        int slot = slot(key);
        if (stamps[slot] != stamp) {
            if (++size > keys.length / 2) {
                grow();
                slot = slot(key);
            }
            stamps[slot] = stamp;
            keys[slot] = key;
        }
        values[slot] = value;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldValues = values;
        int[] oldStamps = stamps;
        keys = new long[2 * oldKeys.length];
        values = new int[keys.length];
        stamps = new int[keys.length];
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldStamps[i] == stamp) {
                int slot = slot(oldKeys[i]);
                stamps[slot] = stamp;
                keys[slot] = oldKeys[i];
                values[slot] = oldValues[i];
            }
        }
    }
}
