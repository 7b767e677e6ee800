package com.mobilerobots.Aria;

/** A double of a sonar reading. */
public class ArSensorReading {
    private final long cycle;

    ArSensorReading(long cycle) {
        this.cycle = cycle;
    }

    public long getCounterTaken() {
        return cycle;
    }
}
