package com.mobilerobots.Aria;

import java.util.concurrent.locks.ReentrantLock;

/**
 * A double of a robot, with the methods that MAJIC uses and no others. It follows its velocities at once and reports
 * every 100 ms; each report shows where it was then.
 */
public class ArRobot {
    private static final long CYCLE_NANOS = 100_000_000;
    private static final double STEP_S = 0.1;

    private final ReentrantLock lock = new ReentrantLock();
    private boolean connected;
    private boolean motors;
    private double speed;
    private double rate;
    private double x;
    private double y;
    private double heading;
    private long cycles;
    private long reportedNanos = System.nanoTime();

    /** What the charger does. */
    public static final class ChargeState {
        public int swigValue() {
            return 0;
        }
    }

    private void advance() {
        if (!lock.isHeldByCurrentThread()) {
            throw new IllegalStateException("called without the lock");
        }
        while (System.nanoTime() - reportedNanos >= CYCLE_NANOS) {
            reportedNanos += CYCLE_NANOS;
            cycles++;
            heading += rate * STEP_S;
            x += speed * STEP_S * Math.cos(Math.toRadians(heading));
            y += speed * STEP_S * Math.sin(Math.toRadians(heading));
        }
    }

    public int tryLock() {
        return lock.tryLock() ? 0 : 3;
    }

    public int unlock() {
        lock.unlock();
        return 0;
    }

    public void setDeviceConnection(ArDeviceConnection connection) {}

    public boolean blockingConnect() {
        connected = true;
        return true;
    }

    public void runAsync(boolean stopRunIfNotConnected) {}

    public void stopRunning(boolean doDisconnect) {
        connected = false;
        speed = 0;
        rate = 0;
    }

    public boolean isConnected() {
        advance();
        return connected;
    }

    public ArTime getLastOdometryTime() {
        advance();
        return new ArTime(reportedNanos);
    }

    public ArSensorReading getSonarReading(int number) {
        return new ArSensorReading(cycles);
    }

    public int getNumSonar() {
        return 16;
    }

    public int getSonarRange(int number) {
        return 3000;
    }

    public void setVel(double velocity) {
        advance();
        speed = motors ? velocity : 0;
    }

    public void setRotVel(double velocity) {
        advance();
        rate = motors ? velocity : 0;
    }

    public void stop() {
        advance();
        speed = 0;
        rate = 0;
    }

    public void enableMotors() {
        motors = true;
    }

    public void disableMotors() {
        motors = false;
    }

    public boolean com(short command) {
        return true;
    }

    public boolean comInt(short command, short argument) {
        return true;
    }

    public boolean com2Bytes(short command, char high, char low) {
        return true;
    }

    public boolean comStrN(short command, String text, int size) {
        return true;
    }

    public String getRobotName() {
        return "Double";
    }

    public String getRobotType() {
        return "Pioneer";
    }

    public String getRobotSubType() {
        return "p3dx-sh";
    }

    public double getX() {
        return x;
    }

    public double getY() {
        return y;
    }

    public double getTh() {
        return Math.IEEEremainder(heading, 360);
    }

    public double getLeftVel() {
        return speed - Math.toRadians(rate) / 0.0056;
    }

    public double getRightVel() {
        return speed + Math.toRadians(rate) / 0.0056;
    }

    public double getRotVel() {
        return rate;
    }

    public int getFlags() {
        return 0x1E | (motors ? 1 : 0);
    }

    public double getControl() {
        return 0;
    }

    public double getCompass() {
        return 0;
    }

    public int getStallValue() {
        return 0;
    }

    public double getBatteryVoltageNow() {
        return 12.5;
    }

    public double getRealBatteryVoltageNow() {
        return 12.5;
    }

    public ChargeState getChargeState() {
        return new ChargeState();
    }

    public boolean haveStateOfCharge() {
        return false;
    }

    public double getStateOfCharge() {
        return 0;
    }

    public boolean hasFaultFlags() {
        return false;
    }

    public int getFaultFlags() {
        return 0;
    }

    public int getTemperature() {
        return -128;
    }

    public int getAnalogPortSelected() {
        return 0;
    }

    public short getAnalog() {
        return 0;
    }

    public short getDigIn() {
        return 0;
    }

    public short getDigOut() {
        return 0;
    }

    public int getIOAnalogSize() {
        return 0;
    }

    public int getIODigInSize() {
        return 0;
    }

    public int getIODigOutSize() {
        return 0;
    }

    public int getIOAnalog(int number) {
        return 0;
    }

    public short getIODigIn(int number) {
        return 0;
    }

    public short getIODigOut(int number) {
        return 0;
    }

    public int getLeftEncoder() {
        return 0;
    }

    public int getRightEncoder() {
        return 0;
    }

    public boolean hasFrontBumpers() {
        return false;
    }

    public long getNumFrontBumpers() {
        return 0;
    }

    public boolean hasRearBumpers() {
        return false;
    }

    public long getNumRearBumpers() {
        return 0;
    }

    public double getAbsoluteMaxTransVel() {
        return 2200;
    }

    public double getAbsoluteMaxRotVel() {
        return 500;
    }

    public void setTransVelMax(double velocity) {}

    public void setTransAccel(double acceleration) {}

    public void setTransDecel(double deceleration) {}

    public void setRotVelMax(double velocity) {}

    public void setRotAccel(double acceleration) {}

    public void setRotDecel(double deceleration) {}
}
