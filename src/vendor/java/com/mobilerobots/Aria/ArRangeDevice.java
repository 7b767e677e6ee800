package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: what measures ranges. {@code tryLockDevice} returns 0 where it succeeded. */
public class ArRangeDevice {
    public int tryLockDevice() {
        throw new SignatureOnly();
    }

    public int unlockDevice() {
        throw new SignatureOnly();
    }

    public long getMaxRange() {
        throw new SignatureOnly();
    }

    public ArSensorReadingVector getRawReadingsAsVector() {
        throw new SignatureOnly();
    }
}
