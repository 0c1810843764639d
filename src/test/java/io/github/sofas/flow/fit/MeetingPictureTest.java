package io.github.sofas.flow.fit;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import io.github.sofas.event.SensorSize;
import java.util.Arrays;
import org.junit.Test;

public class MeetingPictureTest {
    private final MeetingPicture picture = new MeetingPicture(new SensorSize(64, 48));

    private void add(double x, double y, int weight) {
        picture.add(MeetingPicture.place(x), MeetingPicture.place(y), weight);
    }

    /** What an event would meet at a place and beside, row by row. */
    private double[] around(double x, double y) {
        long[] met = new long[9];
        picture.addMeets(MeetingPicture.place(x), MeetingPicture.place(y), met);
        return Arrays.stream(met).mapToDouble(each -> Math.scalb((double) each, -MeetingPicture.MET_BITS)).toArray();
    }

    private double meets(double x, double y) {
        return around(x, y)[4];
    }

    @Test
    public void eventMeetsAnotherByNearness() {
        add(20, 10, 1);
        assertEquals(1, meets(20, 10), 0);
        assertEquals(0.75, meets(20.25, 10), 0);
        assertEquals(0.375, meets(20.25, 10.5), 0);
        assertEquals(0, meets(21, 10), 0);
        // between two pixels, votes and looks spread by half
        add(30.5, 10, 1);
        assertEquals(0.5, meets(30.5, 10), 0);
    }

    @Test
    public void eventsAPixelBesideAreMetThere() {
        add(20.25, 10.5, 1);
        // 0.375 on columns 20 of the rows 10 and 11, 0.125 on columns 21; of two columns 0.75 and 0.25 are looked at
        assertArrayEquals(new double[] {0, 0.09375, 0.3125, 0, 0.09375, 0.3125, 0, 0, 0}, around(19.25, 11), 0);
    }

    @Test
    public void nothingIsLeftOfWhatWasTakenOut() {
        add(20.3, 10.7, 1);
        add(20.9, 10.1, 1);
        add(20.3, 10.7, -1);
        add(20.9, 10.1, -1);
        assertEquals(0, meets(20.5, 10.5), 0);
    }

    @Test
    public void whatIsMovedFarOffTheSensorHasNoVotes() {
        add(-40, 10, 1);
        assertEquals(0, meets(-40, 10), 0);
        add(-10, 10, 1);
        assertEquals(1, meets(-10, 10), 0);
    }

    @Test
    public void clearForgetsAll() {
        add(20.5, 10.5, 1);
        picture.clear();
        assertEquals(0, meets(20.5, 10.5), 0);
        picture.clear();
    }

    private double met(double x, double y, int polarity) {
        return Math.scalb((double) picture.met(MeetingPicture.place(x), MeetingPicture.place(y), polarity),
            -MeetingPicture.MET_BITS);
    }

    @Test
    public void eventOfThePictureDoesNotMeetItself() {
        add(20.25, 10.5, 1);
        assertEquals(0, met(20.25, 10.5, 1), 0);
        add(20.25, 10.5, 1);
        // 0.75² + 0.25² by 0.5² + 0.5²
        assertEquals(0.3125, met(20.25, 10.5, 1), 0);
    }

    @Test
    public void eventsOfTheOtherPolarityCountAgainst() {
        add(20, 10, 1);
        add(20, 10, -1);
        add(20, 10, -1);
        assertEquals(-2, met(20, 10, 1), 0);
        assertEquals(0, met(20, 10, -1), 0);
    }
}
