package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: the last reading of a sonar disc, with the number of ARIA's cycle in which it came. */
public class ArSensorReading {
    public ArSensorReading() {
        throw new SignatureOnly();
    }

    public int getRange() {
        throw new SignatureOnly();
    }

    public long getCounterTaken() {
        throw new SignatureOnly();
    }
}
