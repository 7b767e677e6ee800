package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: connects to the lasers that are named in the robot's parameter file or in the options. */
public class ArLaserConnector {
    public ArLaserConnector(ArArgumentParser parser, ArRobot robot, ArRobotConnector robotConnector) {
        throw new SignatureOnly();
    }

    public boolean connectLasers() {
        throw new SignatureOnly();
    }

    public ArLaser getLaser(int number) {
        throw new SignatureOnly();
    }
}
