package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/**
 * Signature: the last reading of a sonar disc or of one angle of a laser, with the number of ARIA's cycle in which it
 * came. The sensor and the local reading are in the robot's frame; taken is where the robot was.
 */
public class ArSensorReading {
    public ArSensorReading() {
        throw new SignatureOnly();
    }

    public long getRange() {
        throw new SignatureOnly();
    }

    public long getCounterTaken() {
        throw new SignatureOnly();
    }

    public ArTime getTimeTaken() {
        throw new SignatureOnly();
    }

    public boolean getIgnoreThisReading() {
        throw new SignatureOnly();
    }

    public double getSensorX() {
        throw new SignatureOnly();
    }

    public double getSensorY() {
        throw new SignatureOnly();
    }

    public double getSensorTh() {
        throw new SignatureOnly();
    }

    public double getLocalX() {
        throw new SignatureOnly();
    }

    public double getLocalY() {
        throw new SignatureOnly();
    }

    public double getXTaken() {
        throw new SignatureOnly();
    }

    public double getYTaken() {
        throw new SignatureOnly();
    }

    public double getThTaken() {
        throw new SignatureOnly();
    }
}
