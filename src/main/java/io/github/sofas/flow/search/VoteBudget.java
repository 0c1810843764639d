package io.github.sofas.flow.search;

/**
 * The number of votes that the search may give. Each labelled event earns a number of votes, less those of the track
 * planes' measurements, which cannot wait: a thousand events that need many votes of both kinds take no longer than
 * others. Each µs between events earns more, because there is time where few events come. The times are those of the
 * events, not of a clock, so that results do not depend on the machine.
 */
final class VoteBudget {
    /** Votes of measurements and search together for each event. */
    private static final int VOTES_PER_EVENT = 120;
    /** Least votes per event for the search: many tracked structures must not keep others from being found. */
    private static final int LEAST_PER_EVENT = 80;
    /** Votes per µs until the next event: about a fifth of what a processor gives in that time. */
    private static final long VOTES_PER_US = 100;
    /** Longest time between two events that counts, in µs. */
    private static final long MOST_US = 100;
    /** Most votes that are saved up, and most that are owed for measurements. */
    private static final long MOST_SAVED = 40_000;
    private static final long MOST_OWED = 100_000;

    /** Votes of measurements counted so far. */
    private long measured;
    /** Time of the last event, 0 before the first. */
    private long earnedUs;
    private long saved;
    private long owed;

    /** Begins with nothing saved and nothing owed, after a given number of votes of measurements. */
    VoteBudget(long measuringVotes) {
        measured = measuringVotes;
    }

    /**
     * Earns the votes of another event, and of the time since the one before.
     *
     * @param measuringVotes votes that measurements gave so far
     * @param nowUs time of the event
     */
    void earn(long measuringVotes, long nowUs) {
        owed = Math.min(MOST_OWED, owed + measuringVotes - measured);
        measured = measuringVotes;
        long paid = Math.min(owed, VOTES_PER_EVENT - LEAST_PER_EVENT);
        owed -= paid;
        long passedUs = Math.max(0, Math.min(MOST_US, nowUs - earnedUs));
        earnedUs = nowUs;
        saved = Math.min(MOST_SAVED, saved + VOTES_PER_EVENT - paid + VOTES_PER_US * passedUs);
    }

    /** Earns some more votes, which are saved as far as there is room. */
    void earnMore(long votes) {
        saved = Math.min(MOST_SAVED, saved + votes);
    }

    /** Spends votes. The last ones may be more than are left; the events that follow pay for them. */
    void spend(long votes) {
        saved -= votes;
    }

    /** Drops the saved votes: work that may be long begins, and no event is to wait for much of it at once. */
    void letGo() {
        saved = Math.min(saved, 0);
    }

    /** Whether votes are left to give. */
    boolean isLeft() {
        return saved > 0;
    }

    /** Forgets what is saved and owed, and the last event. */
    void clear() {
        saved = 0;
        owed = 0;
        earnedUs = 0;
    }
}
