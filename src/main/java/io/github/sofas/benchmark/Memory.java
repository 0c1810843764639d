package io.github.sofas.benchmark;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.util.List;

/** Heap figures that the Java virtual machine reports, in bytes. */
final class Memory {
    private static final com.sun.management.ThreadMXBean THREADS =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Memory() {
    }

    /** Requests a garbage collection. */
    static void collect() {
        System.gc();
    }

    /** Bytes of the heap in use after a collection. */
    static long usedBytes() {
        collect();
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }

    /** Bytes that this thread has allocated so far; only differences are meaningful. */
    static long allocatedBytes() {
        return THREADS.getCurrentThreadAllocatedBytes();
    }

    /** Requests a garbage collection and resets the peak. */
    static void resetPeak() {
        collect();
        heapPools().forEach(MemoryPoolMXBean::resetPeakUsage);
    }

    /** Sum of the peaks of the heap's pools. At least the true peak, since the pools need not peak at the same time. */
    static long peakBytes() {
        return heapPools().stream().mapToLong(pool -> pool.getPeakUsage().getUsed()).sum();
    }

    private static List<MemoryPoolMXBean> heapPools() {
        return ManagementFactory.getMemoryPoolMXBeans().stream().filter(pool -> pool.getType() == MemoryType.HEAP)
            .toList();
    }
}
