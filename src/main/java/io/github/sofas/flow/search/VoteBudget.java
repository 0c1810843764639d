package io.github.sofas.flow.search;

/**
 * How many votes the search may give: a number for each event that is labelled, less those of the track planes'
 * measurements, which cannot wait, so that a thousand events that need much of both take no longer than others; and a
 * number for each µs between events, because where few come there is time. By the events' own times, not by the clock,
 * so that results do not depend on the machine.
 */
final class VoteBudget {
    /** Votes of measurements and search together for each event. */
    private static final int VOTES_PER_EVENT = 120;
    /** What is left to the search at least: many structures must not keep others from being found. */
    private static final int LEAST_PER_EVENT = 80;
    /** Votes for each µs that passes until the next event: of what a processor gives in that, about a fifth. */
    private static final long VOTES_PER_US = 100;
    /** Longest time between two events that counts, in µs. */
    private static final long MOST_US = 100;
    /** Most votes that are saved up, and that are owed for measurements. */
    private static final long MOST_SAVED = 40_000;
    private static final long MOST_OWED = 100_000;

    /** Votes of measurements that are known of. */
    private long measured;
    /** Time of the last event, 0 before the first. */
    private long earnedUs;
    private long saved;
    private long owed;

    /** Begins with nothing saved and nothing owed after so many votes of measurements. */
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

    /** Forgets what is saved and owed, and the last event. */
    void clear() {
        saved = 0;
        owed = 0;
        earnedUs = 0;
    }
}
