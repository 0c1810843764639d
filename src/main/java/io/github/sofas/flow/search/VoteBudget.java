package io.github.sofas.flow.search;

/**
 * How many votes the search may give: a number for each event that is labelled, less those of the track planes'
 * measurements, which cannot wait. So a thousand events that need much of both take no longer than others. By events,
 * not by time, so that it keeps up with any rate, and results do not depend on the machine.
 */
final class VoteBudget {
    /** Votes of measurements and search together for each event. */
    private static final int VOTES_PER_EVENT = 120;
    /** What is left to the search at least: many structures must not keep others from being found. */
    private static final int LEAST_PER_EVENT = 80;
    /** Most votes that are saved up, and that are owed for measurements. */
    private static final long MOST_SAVED = 40_000;
    private static final long MOST_OWED = 100_000;

    /** Votes of measurements that are known of. */
    private long measured;
    private long saved;
    private long owed;

    /** Begins with nothing saved and nothing owed after so many votes of measurements. */
    VoteBudget(long measuringVotes) {
        measured = measuringVotes;
    }

    /**
     * Earns the votes of another event.
     *
     * @param measuringVotes votes that measurements gave so far
     */
    void earn(long measuringVotes) {
        owed = Math.min(MOST_OWED, owed + measuringVotes - measured);
        measured = measuringVotes;
        long paid = Math.min(owed, VOTES_PER_EVENT - LEAST_PER_EVENT);
        owed -= paid;
        saved = Math.min(MOST_SAVED, saved + VOTES_PER_EVENT - paid);
    }

    /** Earns some more votes, which are saved as far as there is room. */
    void earnMore(long votes) {
        saved = Math.min(MOST_SAVED, saved + votes);
    }

    /** Gives votes; the last ones may be more than are left, for the events that follow to pay. */
    void spend(long votes) {
        saved -= votes;
    }

    /** Lets go what is saved: work that may be long begins, and no event is to wait for much of it at once. */
    void letGo() {
        saved = Math.min(saved, 0);
    }

    /** Whether votes are left to give. */
    boolean isLeft() {
        return saved > 0;
    }

    /** Forgets what is saved and owed. */
    void clear() {
        saved = 0;
        owed = 0;
    }
}
