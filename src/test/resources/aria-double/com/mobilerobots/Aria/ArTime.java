package com.mobilerobots.Aria;

/** A double of a moment. */
public class ArTime {
    private final long nanos;

    ArTime(long nanos) {
        this.nanos = nanos;
    }

    public int mSecSince() {
        return (int) ((System.nanoTime() - nanos) / 1_000_000);
    }

    public void delete() {}
}
