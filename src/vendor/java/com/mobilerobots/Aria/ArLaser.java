package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: a laser scanner. */
public class ArLaser extends ArRangeDevice {
    public boolean isConnected() {
        throw new SignatureOnly();
    }

    public boolean disconnect() {
        throw new SignatureOnly();
    }

    public ArTime getLastReadingTime() {
        throw new SignatureOnly();
    }
}
