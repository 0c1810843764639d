package io.github.sofas.benchmark;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.util.List;

/** What the Java virtual machine says of its heap, in bytes. */
final class Memory {
    private static final com.sun.management.ThreadMXBean THREADS =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Memory() {
    }

    /** Frees what can be freed. */
    static void collect() {
        System.gc();
    }

    /** In use after a collection. */
    static long usedBytes() {
        collect();
        return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed();
    }

    /** Allocated by this thread so far; only differences mean anything. */
    static long allocatedBytes() {
        return THREADS.getCurrentThreadAllocatedBytes();
    }

    /** Frees what can be freed and forgets the peak so far. */
    static void resetPeak() {
        collect();
        heapPools().forEach(MemoryPoolMXBean::resetPeakUsage);
    }

    /** The sum over the parts of the heap, so at least the true peak: the parts need not have peaked together. */
    static long peakBytes() {
        return heapPools().stream().mapToLong(pool -> pool.getPeakUsage().getUsed()).sum();
    }

    private static List<MemoryPoolMXBean> heapPools() {
        return ManagementFactory.getMemoryPoolMXBeans().stream().filter(pool -> pool.getType() == MemoryType.HEAP)
            .toList();
    }
}
