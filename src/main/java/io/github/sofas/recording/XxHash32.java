package io.github.sofas.recording;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;

/** The checksum of LZ4 frames: xxHash, 32 bits, seed 0 (github.com/Cyan4973/xxHash, doc/xxhash_spec.md). */
final class XxHash32 {
    private static final VarHandle INT = MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);
    private static final int PRIME_1 = 0x9E3779B1;
    private static final int PRIME_2 = 0x85EBCA77;
    private static final int PRIME_3 = 0xC2B2AE3D;
    private static final int PRIME_4 = 0x27D4EB2F;
    private static final int PRIME_5 = 0x165667B1;
    private static final int STRIPE_BYTES = 16;

    private XxHash32() {
    }

    /** The checksum of the bytes from {@code from} to before {@code to}. */
    static int of(byte[] bytes, int from, int to) {
        int p = from;
        int hash;
        if (to - from >= STRIPE_BYTES) {
            int a = PRIME_1 + PRIME_2;
            int b = PRIME_2;
            int c = 0;
            int d = -PRIME_1;
            for (; p <= to - STRIPE_BYTES; p += STRIPE_BYTES) {
                a = round(a, (int) INT.get(bytes, p));
                b = round(b, (int) INT.get(bytes, p + 4));
                c = round(c, (int) INT.get(bytes, p + 8));
                d = round(d, (int) INT.get(bytes, p + 12));
            }
            hash = Integer.rotateLeft(a, 1) + Integer.rotateLeft(b, 7) + Integer.rotateLeft(c, 12)
                    + Integer.rotateLeft(d, 18);
        } else {
            hash = PRIME_5;
        }
        hash += to - from;
        for (; p <= to - 4; p += 4) {
            hash = Integer.rotateLeft(hash + (int) INT.get(bytes, p) * PRIME_3, 17) * PRIME_4;
        }
        for (; p < to; p++) {
            hash = Integer.rotateLeft(hash + (bytes[p] & 0xFF) * PRIME_5, 11) * PRIME_1;
        }
        hash = (hash ^ hash >>> 15) * PRIME_2;
        hash = (hash ^ hash >>> 13) * PRIME_3;
        return hash ^ hash >>> 16;
    }

    private static int round(int lane, int input) {
        return Integer.rotateLeft(lane + input * PRIME_2, 13) * PRIME_1;
    }
}
