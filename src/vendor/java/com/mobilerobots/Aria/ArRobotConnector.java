package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: what tells whether a robot is simulated. */
public class ArRobotConnector {
    public ArRobotConnector(ArArgumentParser parser, ArRobot robot) {
        throw new SignatureOnly();
    }
}
