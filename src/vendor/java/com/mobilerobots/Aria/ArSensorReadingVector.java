package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: readings in the order of their angles. */
public class ArSensorReadingVector {
    public long size() {
        throw new SignatureOnly();
    }

    public ArSensorReading get(int index) {
        throw new SignatureOnly();
    }
}
