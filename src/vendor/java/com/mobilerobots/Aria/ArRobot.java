package com.mobilerobots.Aria;

import signatures.SignatureOnly;

/** Signature: a robot. {@code lock} and {@code unlock} return 0 where they succeeded; all is called between them. */
public class ArRobot {
    /** What the charger does; a class, not an enum, as SWIG makes it. */
    public static final class ChargeState {
        private final int value;

        private ChargeState(int value) {
            this.value = value;
        }

        public int swigValue() {
            return value;
        }
    }

    public ArRobot() {
        throw new SignatureOnly();
    }

    public void delete() {
        throw new SignatureOnly();
    }

    public void setDeviceConnection(ArDeviceConnection connection) {
        throw new SignatureOnly();
    }

    public boolean blockingConnect() {
        throw new SignatureOnly();
    }

    public boolean disconnect() {
        throw new SignatureOnly();
    }

    public boolean isConnected() {
        throw new SignatureOnly();
    }

    public boolean isRunning() {
        throw new SignatureOnly();
    }

    public void runAsync(boolean stopRunIfNotConnected) {
        throw new SignatureOnly();
    }

    public void stopRunning(boolean doDisconnect) {
        throw new SignatureOnly();
    }

    public int lock() {
        throw new SignatureOnly();
    }

    public int tryLock() {
        throw new SignatureOnly();
    }

    public int unlock() {
        throw new SignatureOnly();
    }

    public void setConnectionTimeoutTime(int milliseconds) {
        throw new SignatureOnly();
    }

    public int getConnectionTimeoutTime() {
        throw new SignatureOnly();
    }

    public void setCycleTime(long milliseconds) {
        throw new SignatureOnly();
    }

    public long getCycleTime() {
        throw new SignatureOnly();
    }

    public long getCounter() {
        throw new SignatureOnly();
    }

    public void setDoNotSwitchBaud(boolean doNotSwitchBaud) {
        throw new SignatureOnly();
    }

    public void setStateReflectionRefreshTime(int milliseconds) {
        throw new SignatureOnly();
    }

    public void setDirectMotionPrecedenceTime(int milliseconds) {
        throw new SignatureOnly();
    }

    public void clearDirectMotion() {
        throw new SignatureOnly();
    }

    public void stopStateReflection() {
        throw new SignatureOnly();
    }

    public void enableMotors() {
        throw new SignatureOnly();
    }

    public void disableMotors() {
        throw new SignatureOnly();
    }

    public void enableSonar() {
        throw new SignatureOnly();
    }

    public void disableSonar() {
        throw new SignatureOnly();
    }

    public void stop() {
        throw new SignatureOnly();
    }

    public void setVel(double velocity) {
        throw new SignatureOnly();
    }

    public void setVel2(double leftVelocity, double rightVelocity) {
        throw new SignatureOnly();
    }

    public void setRotVel(double velocity) {
        throw new SignatureOnly();
    }

    public void setLatVel(double velocity) {
        throw new SignatureOnly();
    }

    public boolean com(short command) {
        throw new SignatureOnly();
    }

    public boolean comInt(short command, short argument) {
        throw new SignatureOnly();
    }

    public boolean com2Bytes(short command, char high, char low) {
        throw new SignatureOnly();
    }

    public boolean comStr(short command, String argument) {
        throw new SignatureOnly();
    }

    public boolean comStrN(short command, String text, int size) {
        throw new SignatureOnly();
    }

    public String getRobotName() {
        throw new SignatureOnly();
    }

    public String getRobotType() {
        throw new SignatureOnly();
    }

    public String getRobotSubType() {
        throw new SignatureOnly();
    }

    public double getX() {
        throw new SignatureOnly();
    }

    public double getY() {
        throw new SignatureOnly();
    }

    public double getTh() {
        throw new SignatureOnly();
    }

    public double getEncoderX() {
        throw new SignatureOnly();
    }

    public double getEncoderY() {
        throw new SignatureOnly();
    }

    public double getEncoderTh() {
        throw new SignatureOnly();
    }

    public double getVel() {
        throw new SignatureOnly();
    }

    public double getRotVel() {
        throw new SignatureOnly();
    }

    public double getLatVel() {
        throw new SignatureOnly();
    }

    public double getLeftVel() {
        throw new SignatureOnly();
    }

    public double getRightVel() {
        throw new SignatureOnly();
    }

    public double getControl() {
        throw new SignatureOnly();
    }

    public double getBatteryVoltageNow() {
        throw new SignatureOnly();
    }

    public double getRealBatteryVoltageNow() {
        throw new SignatureOnly();
    }

    public boolean haveStateOfCharge() {
        throw new SignatureOnly();
    }

    public double getStateOfCharge() {
        throw new SignatureOnly();
    }

    public boolean hasTemperature() {
        throw new SignatureOnly();
    }

    public int getTemperature() {
        throw new SignatureOnly();
    }

    public int getStallValue() {
        throw new SignatureOnly();
    }

    public boolean isLeftMotorStalled() {
        throw new SignatureOnly();
    }

    public boolean isRightMotorStalled() {
        throw new SignatureOnly();
    }

    public int getFlags() {
        throw new SignatureOnly();
    }

    public boolean hasFaultFlags() {
        throw new SignatureOnly();
    }

    public int getFaultFlags() {
        throw new SignatureOnly();
    }

    public boolean hasFlags3() {
        throw new SignatureOnly();
    }

    public int getFlags3() {
        throw new SignatureOnly();
    }

    public boolean areMotorsEnabled() {
        throw new SignatureOnly();
    }

    public boolean areSonarsEnabled() {
        throw new SignatureOnly();
    }

    public boolean isEStopPressed() {
        throw new SignatureOnly();
    }

    public double getCompass() {
        throw new SignatureOnly();
    }

    public int getAnalogPortSelected() {
        throw new SignatureOnly();
    }

    public short getAnalog() {
        throw new SignatureOnly();
    }

    public short getDigIn() {
        throw new SignatureOnly();
    }

    public short getDigOut() {
        throw new SignatureOnly();
    }

    public ChargeState getChargeState() {
        throw new SignatureOnly();
    }

    public ArTime getLastOdometryTime() {
        throw new SignatureOnly();
    }

    public int getMotorPacCount() {
        throw new SignatureOnly();
    }

    public int getSonarPacCount() {
        throw new SignatureOnly();
    }

    public int getNumSonar() {
        throw new SignatureOnly();
    }

    public int getSonarRange(int number) {
        throw new SignatureOnly();
    }

    public ArSensorReading getSonarReading(int number) {
        throw new SignatureOnly();
    }

    public boolean isSonarNew(int number) {
        throw new SignatureOnly();
    }

    public boolean hasFrontBumpers() {
        throw new SignatureOnly();
    }

    public long getNumFrontBumpers() {
        throw new SignatureOnly();
    }

    public boolean hasRearBumpers() {
        throw new SignatureOnly();
    }

    public long getNumRearBumpers() {
        throw new SignatureOnly();
    }

    public void requestIOPackets() {
        throw new SignatureOnly();
    }

    public void stopIOPackets() {
        throw new SignatureOnly();
    }

    public int getIOAnalogSize() {
        throw new SignatureOnly();
    }

    public int getIODigInSize() {
        throw new SignatureOnly();
    }

    public int getIODigOutSize() {
        throw new SignatureOnly();
    }

    public int getIOAnalog(int number) {
        throw new SignatureOnly();
    }

    public short getIODigIn(int number) {
        throw new SignatureOnly();
    }

    public short getIODigOut(int number) {
        throw new SignatureOnly();
    }

    public void requestEncoderPackets() {
        throw new SignatureOnly();
    }

    public void stopEncoderPackets() {
        throw new SignatureOnly();
    }

    public int getLeftEncoder() {
        throw new SignatureOnly();
    }

    public int getRightEncoder() {
        throw new SignatureOnly();
    }

    public double getAbsoluteMaxTransVel() {
        throw new SignatureOnly();
    }

    public double getAbsoluteMaxTransNegVel() {
        throw new SignatureOnly();
    }

    public double getAbsoluteMaxRotVel() {
        throw new SignatureOnly();
    }

    public double getTransVelMax() {
        throw new SignatureOnly();
    }

    public double getRotVelMax() {
        throw new SignatureOnly();
    }

    public double getTransAccel() {
        throw new SignatureOnly();
    }

    public double getTransDecel() {
        throw new SignatureOnly();
    }

    public double getRotAccel() {
        throw new SignatureOnly();
    }

    public double getRotDecel() {
        throw new SignatureOnly();
    }

    public void setTransVelMax(double velocity) {
        throw new SignatureOnly();
    }

    public void setTransNegVelMax(double velocity) {
        throw new SignatureOnly();
    }

    public void setRotVelMax(double velocity) {
        throw new SignatureOnly();
    }

    public void setTransAccel(double acceleration) {
        throw new SignatureOnly();
    }

    public void setTransDecel(double deceleration) {
        throw new SignatureOnly();
    }

    public void setRotAccel(double acceleration) {
        throw new SignatureOnly();
    }

    public void setRotDecel(double deceleration) {
        throw new SignatureOnly();
    }

    public double getRobotRadius() {
        throw new SignatureOnly();
    }

    public double getRobotWidth() {
        throw new SignatureOnly();
    }

    public double getRobotLength() {
        throw new SignatureOnly();
    }
}
