package majic.pioneer.aria;

import com.mobilerobots.Aria.ArRobot;
import com.mobilerobots.Aria.ArSensorReading;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntUnaryOperator;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import majic.bot.Pose;
import majic.pioneer.arcos.Config;
import majic.pioneer.arcos.ConfigField;
import majic.pioneer.arcos.Encoders;
import majic.pioneer.arcos.InputsOutputs;
import majic.pioneer.arcos.PioneerIdentity;
import majic.pioneer.arcos.Report;
import majic.pioneer.arcos.Sip;
import majic.pioneer.arcos.SipField;
import majic.pioneer.state.Models;
import majic.pioneer.state.Scaling;

/**
 * Makes reports from the values that ARIA has of a robot, as if they had come in packets. All methods must be called
 * with ARIA's lock held. For one thread and one session.
 */
final class AriaReports {
    private static final int STATIONARY = 0x32;
    private static final int BYTE = 0xFF;
    private static final int COUNTER = 0x10000;
    private static final int NO_CHARGE_STATE = 255;
    private static final long UNTOLD = Long.MIN_VALUE;

    private static final double DEG_PER_COMPASS_STEP = 2;

    private final ArRobot robot;
    private final SipDetector detector;
    private final Map<Integer, Long> sonarCycles = new HashMap<>();
    private boolean withoutSonarCycles;
    private Pose pose = Pose.START;
    private Scaling scaling = Models.USUAL.scaling();

    AriaReports(ArRobot robot) {
        this.robot = robot;
        this.detector = new SipDetector(robot);
    }

    PioneerIdentity identity() {
        PioneerIdentity identity = new PioneerIdentity(
                told(robot::getRobotName, ""), told(robot::getRobotType, ""), told(robot::getRobotSubType, ""));
        scaling = Models.of(identity.subclass()).scaledByLibrary().scaling();
        return identity;
    }

    /** The fields of CONFIG that ARIA gives. */
    Config config() {
        Map<ConfigField, Object> known = new EnumMap<>(ConfigField.class);
        Map<ConfigField, Supplier<Long>> getters = Map.of(
                ConfigField.TRANSVELTOP, () -> (long) robot.getAbsoluteMaxTransVel(),
                ConfigField.ROTVELTOP, () -> (long) robot.getAbsoluteMaxRotVel(),
                ConfigField.FRONTBUMPS, () -> robot.hasFrontBumpers() ? robot.getNumFrontBumpers() : 0L,
                ConfigField.REARBUMPS, () -> robot.hasRearBumpers() ? robot.getNumRearBumpers() : 0L);
        getters.forEach((field, getter) -> {
            long value = told(getter, UNTOLD);
            if (value != UNTOLD) {
                known.put(field, value);
            }
        });
        return Config.of(known);
    }

    /**
     * Reads a value without which the robot can be driven all the same. An installed ARIA may have no such method, or
     * may not know the value that the robot has sent.
     */
    private static <T> T told(Supplier<T> getter, T otherwise) {
        try {
            return getter.get();
        } catch (LinkageError | RuntimeException e) {
            return otherwise;
        }
    }

    private static int told(Supplier<Integer> getter) {
        return told(getter, Sip.ABSENT);
    }

    boolean hasNewSip(long nowNanos) {
        return detector.isNew(nowNanos);
    }

    /** Where ARIA had the robot in the last SIP; the start before. */
    Pose pose() {
        return pose;
    }

    Sip sip() {
        pose = new Pose(robot.getX(), robot.getY(), robot.getTh());
        int stall = robot.getStallValue();
        Map<SipField, Integer> fields = new EnumMap<>(SipField.class);
        fields.put(SipField.TYPE, STATIONARY);
        fields.put(SipField.X_POS, counter(pose.xMm() / scaling.mmPerCount()));
        fields.put(SipField.Y_POS, counter(pose.yMm() / scaling.mmPerCount()));
        fields.put(SipField.TH_POS, rounded(pose.headingDeg() / scaling.degPerCount()));
        fields.put(SipField.L_VEL, rounded(robot.getLeftVel() / scaling.mmPerSecPerCount()));
        fields.put(SipField.R_VEL, rounded(robot.getRightVel() / scaling.mmPerSecPerCount()));
        fields.put(SipField.BATTERY, rounded(robot.getBatteryVoltageNow() * 10));
        fields.put(SipField.STALL_REAR, stall & BYTE);
        fields.put(SipField.STALL_FRONT, stall >> 8 & BYTE);
        fields.put(SipField.CONTROL, told(() -> rounded(robot.getControl() / scaling.degPerCount()), 0));
        fields.put(SipField.FLAGS, robot.getFlags());
        fields.put(SipField.COMPASS, told(() -> rounded(robot.getCompass() / DEG_PER_COMPASS_STEP), 0));
        addTail(fields);
        return Sip.of(fields, sonar());
    }

    private static int rounded(double value) {
        return (int) Math.round(value);
    }

    private static int counter(double counts) {
        return Math.floorMod(Math.round(counts), COUNTER);
    }

    private void addTail(Map<SipField, Integer> fields) {
        fields.put(SipField.ANALOG_PORT, told(robot::getAnalogPortSelected));
        fields.put(SipField.ANALOG, told(() -> robot.getAnalog() & BYTE));
        fields.put(SipField.DIG_IN, told(() -> robot.getDigIn() & BYTE));
        fields.put(SipField.DIG_OUT, told(() -> robot.getDigOut() & BYTE));
        fields.put(SipField.BATTERY_TENTHS, told(this::batteryTenths));
        fields.put(SipField.CHARGE_STATE, told(this::chargeState));
        fields.put(SipField.TURN_RATE_TENTHS, rounded(robot.getRotVel() * 10));
        fields.put(SipField.FAULT_FLAGS, told(() -> robot.hasFaultFlags() ? robot.getFaultFlags() : Sip.ABSENT));
        fields.put(SipField.TEMPERATURE, told(robot::getTemperature));
        fields.put(
                SipField.CHARGE_PERCENT,
                told(() -> robot.haveStateOfCharge() ? rounded(robot.getStateOfCharge()) : 0, 0));
    }

    private int batteryTenths() {
        double volts = robot.getRealBatteryVoltageNow();
        return volts > 0 ? rounded(volts * 10) : Sip.ABSENT;
    }

    private int chargeState() {
        int charging = robot.getChargeState().swigValue();
        return charging < 0 ? NO_CHARGE_STATE : charging;
    }

    private Map<Integer, Integer> sonar() {
        Map<Integer, Integer> fresh = new LinkedHashMap<>();
        for (int disc = 0; disc < robot.getNumSonar(); disc++) {
            int rangeMm = robot.getSonarRange(disc);
            if (rangeMm >= 0 && hasFired(disc)) {
                fresh.put(disc, rounded(rangeMm / scaling.mmPerRangeCount()));
            }
        }
        return fresh;
    }

    /** Whether a disc has a newer reading than before; always, if this ARIA does not tell in which cycle it came. */
    private boolean hasFired(int disc) {
        if (withoutSonarCycles) {
            return true;
        }
        try {
            ArSensorReading reading = robot.getSonarReading(disc);
            Long cycle = reading == null ? null : reading.getCounterTaken();
            return cycle != null && !cycle.equals(sonarCycles.put(disc, cycle));
        } catch (LinkageError e) {
            withoutSonarCycles = true;
            return true;
        }
    }

    /** Reports of ports and encoders, as far as ARIA has received any. */
    List<Report> others() {
        List<Report> reports = new ArrayList<>();
        reports.addAll(told(this::ports, List.of()));
        reports.addAll(told(this::encoders, List.of()));
        return reports;
    }

    private List<Report> ports() {
        int inputs = robot.getIODigInSize();
        int outputs = robot.getIODigOutSize();
        int analogs = robot.getIOAnalogSize();
        return inputs + outputs + analogs == 0
                ? List.of()
                : List.of(new InputsOutputs(
                        values(inputs, number -> robot.getIODigIn(number) & BYTE),
                        values(outputs, number -> robot.getIODigOut(number) & BYTE),
                        values(analogs, robot::getIOAnalog)));
    }

    private List<Report> encoders() {
        Encoders encoders = new Encoders(robot.getLeftEncoder(), robot.getRightEncoder());
        return encoders.equals(new Encoders(0, 0)) ? List.of() : List.of(encoders);
    }

    private static List<Integer> values(int count, IntUnaryOperator reader) {
        return IntStream.range(0, count).map(reader).boxed().toList();
    }
}
