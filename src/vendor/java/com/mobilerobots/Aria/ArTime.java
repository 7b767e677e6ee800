package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: a moment. */
public class ArTime {
    public ArTime() {
        throw new SignatureOnly();
    }

    public int mSecSince() {
        throw new SignatureOnly();
    }

    public boolean isAt(ArTime other) {
        throw new SignatureOnly();
    }

    public void delete() {
        throw new SignatureOnly();
    }
}
