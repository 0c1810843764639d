package io.github.sofas.flow.track;

import java.util.function.IntPredicate;

/**
 * The live events of a track plane that its motion is measured from, a ring in order of time: those of the time in
 * which it travels its lifetime.
 *
 * <p>Ours: what must be bounded is memory, and what must be kept is travel. A dense structure is measured on a part of
 * it: only events of some of its tiles are taken, half of the tiles after each time that the ring is full. Of whole
 * tiles, because thinning events one by one thins their meetings by the square.
 */
final class LiveEvents {
    static final int CAPACITY = 1 << 15;
    /** Bytes of its arrays. */
    static final long BYTES = (long) CAPACITY * (Long.BYTES + 2 * Short.BYTES + 2 * Byte.BYTES + Integer.BYTES);
    /** Mean polarity beyond which events have one, but for noise, as those of an edge; a whole body gives either. */
    private static final double LEAST_MEAN_POLARITY = 0.6;
    private static final int MASK = CAPACITY - 1;
    private static final Claim[] CLAIMS = Claim.values();
    /** Part of the events that must stay, and that must go, for the tiles to be halved. */
    private static final int LEAST_PART = 4;
    /** Tiles are halved no further than this many times. */
    private static final int MOST_HALVINGS = 12;

    final long[] timeUs = new long[CAPACITY];
    final short[] x = new short[CAPACITY];
    final short[] y = new short[CAPACITY];
    /** +1 or -1. */
    final byte[] sign = new byte[CAPACITY];
    /** Why the event was taken, as the claim's ordinal: references would be told to the garbage collector. */
    private final byte[] claim = new byte[CAPACITY];
    /** Hash of the tile that the event lies on. */
    private final int[] tile = new int[CAPACITY];

    private int head;
    private int size;
    /** Sum of their polarities. */
    private int signs;
    private int halvings;
    /** Events for which it is not asked again whether tiles can be halved. */
    private int refused;
    /** How many of the oldest events came when only half of the tiles were taken that are now. */
    private int ofHalfTheTiles;

    int size() {
        return size;
    }

    boolean isFull() {
        return size == CAPACITY;
    }

    /** The structure's events to those that are taken. */
    int thinning() {
        return 1 << halvings;
    }

    /** The polarity, 1 or -1, that more than four fifths of them have; 0 where there is none. */
    int commonPolarity() {
        return Math.abs(signs) > LEAST_MEAN_POLARITY * size ? Integer.signum(signs) : 0;
    }

    /** How many events the structure gave, those of tiles that were not taken included. */
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

    /** Whether an event, by its index, lies on a tile that is left when they are halved so many times. */
    boolean isLeftBy(int times, int i) {
        return isTaken(tile[i], halvings + times);
    }

    /** Index into the arrays of the k-th event, 0 the oldest. */
    int index(int k) {
        return head - size + k & MASK;
    }

    long oldestUs() {
        return timeUs[index(0)];
    }

    long newestUs() {
        return timeUs[index(size - 1)];
    }

    /** The middle between the times of the oldest and of the newest event. */
    long middleUs() {
        return oldestUs() + (newestUs() - oldestUs()) / 2;
    }

    /** When the first of so many of the newest events was. */
    long newestFromUs(int newest) {
        return timeUs[index(size - newest)];
    }

    /** Why an event was taken, by its index into the arrays. */
    Claim claim(int i) {
        return CLAIMS[claim[i]];
    }

    /** Appends an event of a tile that is taken; where there is no room, half of the tiles are given up first. */
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

    /** Halves the tiles where about half of the events stay; of a structure of few tiles the oldest event goes. */
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

    /** Keeps only the events, by their indices, of which something is true. */
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

    /** Takes events of twice as many tiles where those that are taken leave the ring nearly empty. */
    void widen() {
        if (halvings > 0 && size < CAPACITY / 4) {
            halvings--;
            ofHalfTheTiles = size;
        }
    }

    /** Lets the events before a time go. */
    void expire(long beforeUs) {
        while (size > 0 && oldestUs() < beforeUs) {
            letOldestGo();
        }
    }

    /** Lets all but so many of the newest go. */
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

    /** Takes over the events of two others, in order of time, of the tiles that both take. */
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
