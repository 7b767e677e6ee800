package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: options of a program; the first word is its name. */
public class ArArgumentParser {
    public ArArgumentParser(String[] words) {
        throw new SignatureOnly();
    }

    public void loadDefaultArguments() {
        throw new SignatureOnly();
    }
}
