package io.github.sofas.flow.track;

import java.util.function.IntPredicate;

/**
 * The live events of a track plane, from which its motion is measured: a ring, in order of time, of the events within
 * the time that the structure takes to travel its lifetime.
 *
 * <p>Ours: memory must be bounded, but the travel must be kept. A dense structure is therefore measured on a part of
 * its area. The ring takes events of some tiles only, and halves the tiles each time that it is full. Whole tiles are
 * kept or dropped, because thinning events one by one would thin their meetings by the square.
 */
final class LiveEvents {
    static final int CAPACITY = 1 << 15;
    /** Bytes that the arrays take. */
    static final long BYTES = (long) CAPACITY * (Long.BYTES + 2 * Short.BYTES + 2 * Byte.BYTES + Integer.BYTES);
    /** Mean polarity beyond which events share one, but for noise, as those of an edge do; a whole body gives both. */
    private static final double LEAST_MEAN_POLARITY = 0.6;
    private static final int MASK = CAPACITY - 1;
    private static final Claim[] CLAIMS = Claim.values();
    /** One part in this many of the events must stay, and as many must go, for the tiles to be halved. */
    private static final int LEAST_PART = 4;
    /** Most times that the tiles are halved. */
    private static final int MOST_HALVINGS = 12;

    final long[] timeUs = new long[CAPACITY];
    final short[] x = new short[CAPACITY];
    final short[] y = new short[CAPACITY];
    /** +1 or -1. */
    final byte[] sign = new byte[CAPACITY];
    /** Why the event was taken, as the ordinal of the claim: storing references would involve the garbage collector. */
    private final byte[] claim = new byte[CAPACITY];
    /** Hash of the tile that the event lies on. */
    private final int[] tile = new int[CAPACITY];

    private int head;
    private int size;
    /** Sum of the polarities of the events. */
    private int signs;
    private int halvings;
    /** Number of further events until halving the tiles is considered again. */
    private int refused;
    /** Number of the oldest events that came while only half of the current tiles were taken. */
    private int ofHalfTheTiles;

    int size() {
        return size;
    }

    boolean isFull() {
        return size == CAPACITY;
    }

    /** Returns the ratio of the structure's events to those that are taken. */
    int thinning() {
        return 1 << halvings;
    }

    /** Returns the polarity, 1 or -1, that more than four fifths of the events have; 0 if there is none. */
    int commonPolarity() {
        return Math.abs(signs) > LEAST_MEAN_POLARITY * size ? Integer.signum(signs) : 0;
    }

    /** Returns the number of events that the structure gave, extrapolated to the tiles that were not taken. */
    long given() {
        return (long) (size + ofHalfTheTiles) << halvings;
    }

    /** Whether events of a tile are taken. */
    boolean takes(int tileHash) {
        return isTaken(tileHash, halvings);
    }

    private static boolean isTaken(int tileHash, int halvings) {
        return (tileHash & (1 << halvings) - 1) == 0;
    }

    /** Whether the event at an index lies on a tile that remains when the tiles are halved so many times. */
    boolean isLeftBy(int times, int i) {
        return isTaken(tile[i], halvings + times);
    }

    /** Returns the index into the arrays of the k-th event; 0 is the oldest. */
    int index(int k) {
        return head - size + k & MASK;
    }

    long oldestUs() {
        return timeUs[index(0)];
    }

    long newestUs() {
        return timeUs[index(size - 1)];
    }

    /** Returns the middle between the times of the oldest and of the newest event. */
    long middleUs() {
        return oldestUs() + (newestUs() - oldestUs()) / 2;
    }

    /** Returns the time of the first of so many newest events. */
    long newestFromUs(int newest) {
        return timeUs[index(size - newest)];
    }

    /** Returns the number of events after a time. */
    int since(long us) {
        int newest = 0;
        while (newest < size && timeUs[index(size - 1 - newest)] > us) {
            newest++;
        }
        return newest;
    }

    /** Returns why an event was taken, by its index into the arrays. */
    Claim claim(int i) {
        return CLAIMS[claim[i]];
    }

    /** Appends an event, if its tile is taken. A full ring makes room first, by half of the tiles if possible. */
    void add(int eventX, int eventY, long eventUs, int polarity, Claim why, int tileHash) {
        add(eventX, eventY, eventUs, polarity, why.ordinal(), tileHash);
    }

    private void add(int eventX, int eventY, long eventUs, int polarity, int why, int tileHash) {
        if (isFull()) {
            makeRoom();
        }
        if (takes(tileHash)) {
            put(eventX, eventY, eventUs, polarity, why, tileHash);
        }
    }

    private void put(int eventX, int eventY, long eventUs, int polarity, int why, int tileHash) {
        int i = head & MASK;
        timeUs[i] = eventUs;
        x[i] = (short) eventX;
        y[i] = (short) eventY;
        sign[i] = (byte) polarity;
        claim[i] = (byte) why;
        tile[i] = tileHash;
        signs += polarity;
        head = head + 1 & MASK;
        size++;
    }

    /** Halves the tiles if about half of the events would stay; else, with few tiles, drops the oldest event. */
    private void makeRoom() {
        if (refused > 0) {
            refused--;
            letOldestGo();
            return;
        }
        int staying = 0;
        for (int k = 0; k < size; k++) {
            staying += isLeftBy(1, index(k)) ? 1 : 0;
        }
        if (halvings < MOST_HALVINGS && staying > size / LEAST_PART && staying < size - size / LEAST_PART) {
            halve();
        } else {
            refused = CAPACITY / LEAST_PART;
            letOldestGo();
        }
    }

    private void letOldestGo() {
        signs -= sign[index(0)];
        size--;
        ofHalfTheTiles = Math.max(0, ofHalfTheTiles - 1);
    }

    private void halve() {
        halvings++;
        ofHalfTheTiles = 0;
        keepIf(i -> takes(tile[i]));
    }

    /** Keeps only the events whose index satisfies a predicate. */
    void keepIf(IntPredicate kept) {
        int n = size;
        int ofHalf = ofHalfTheTiles;
        int from = head - n;
        head = from;
        size = 0;
        signs = 0;
        for (int k = 0; k < n; k++) {
            int i = from + k & MASK;
            if (kept.test(i)) {
                put(x[i], y[i], timeUs[i], sign[i], claim[i], tile[i]);
            } else if (k < ofHalf) {
                ofHalfTheTiles--;
            }
        }
    }

    /** Takes events of twice as many tiles from now on if the ring is less than a quarter full. */
    void widen() {
        if (halvings > 0 && size < CAPACITY / 4) {
            halvings--;
            ofHalfTheTiles = size;
        }
    }

    /** Drops the events before a time. */
    void expire(long beforeUs) {
        while (size > 0 && oldestUs() < beforeUs) {
            letOldestGo();
        }
    }

    /** Drops all events but so many of the newest. */
    void keepNewest(int most) {
        while (size > most) {
            letOldestGo();
        }
    }

    void clear() {
        size = 0;
        signs = 0;
        ofHalfTheTiles = 0;
        halvings = 0;
        refused = 0;
    }

    /** Replaces the events by those of two other rings, in order of time, on the tiles that both take. */
    void fillFrom(LiveEvents a, LiveEvents b) {
        clear();
        halvings = Math.max(a.halvings, b.halvings);
        int ka = 0;
        int kb = 0;
        while (ka < a.size && kb < b.size) {
            if (a.timeUs[a.index(ka)] <= b.timeUs[b.index(kb)]) {
                takeOver(a, ka++);
            } else {
                takeOver(b, kb++);
            }
        }
        while (ka < a.size) {
            takeOver(a, ka++);
        }
        while (kb < b.size) {
            takeOver(b, kb++);
        }
    }

    private void takeOver(LiveEvents from, int k) {
        int i = from.index(k);
        int tileHash = from.tile[i];
        if (takes(tileHash)) {
            add(from.x[i], from.y[i], from.timeUs[i], from.sign[i], from.claim[i], tileHash);
        }
    }
}
