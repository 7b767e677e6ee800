package majicsim.aibo;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.World;

/** What the dog feels (URBI sheet, section 13): distances from the room, the rest from its own state. */
final class Sensors {
    private static final double GRAVITY = 9.80665;
    private static final double NECK_AHEAD_MM = 90;
    private static final double NOSE_MM = 60;
    private static final double HEAD_HEIGHT_MM = 200;
    private static final double CHEST_AHEAD_MM = 100;
    /** The chest looks down at the floor in front of the feet: without a wall it sees that. */
    private static final double CHEST_FLOOR_CM = 40;

    private static final double DISTANCE_SPREAD = 0.02;
    private static final double FAR_MM = 2000;

    private final World world;
    private final Body body;
    private final Noise noise;
    private final Map<String, Double> touched = new LinkedHashMap<>();

    Sensors(World world, Body body, Noise noise) {
        this.world = world;
        this.body = body;
        this.noise = noise;
    }

    /** Makes the variables of all sensors. */
    void install(Variables variables, Map<String, Joint> joints, Legs legs) {
        DoubleSupplier head = () -> headCm(joints);
        distance(variables, "distanceNear", 5.7, 50, head);
        distance(variables, "distance", 20, 150, head);
        distance(variables, "distanceFar", 20, 150, head);
        distance(variables, "distanceChest", 19, 90, this::chestCm);
        acceleration(variables, "accelX", 0);
        acceleration(variables, "accelY", 0);
        acceleration(variables, "accelZ", -GRAVITY);
        for (String paw : List.of("pawLF", "pawLH", "pawRF", "pawRH")) {
            sensor(variables, paw, 0, 1, () -> legs.guess().equals("stand") ? 1 : 0);
        }
        touch(variables, "chinSensor", 1);
        touch(variables, "headSensor", 35);
        touch(variables, "backSensorF", 60);
        touch(variables, "backSensorM", 60);
        touch(variables, "backSensorR", 60);
        touch(variables, "WIFIswitch", 1);
    }

    /** Sets what a touch sensor feels, in its own unit. */
    void touch(String sensor, double value) {
        if (!touched.containsKey(sensor)) {
            throw new IllegalArgumentException("no touch sensor " + sensor + ", only " + touched.keySet());
        }
        touched.put(sensor, value);
    }

    private void distance(Variables variables, String name, double minCm, double maxCm, DoubleSupplier cm) {
        sensor(variables, name, minCm, maxCm, () -> cm.getAsDouble() * noise.scale(DISTANCE_SPREAD));
    }

    private void acceleration(Variables variables, String name, double rest) {
        sensor(variables, name, -2 * GRAVITY, 2 * GRAVITY, () -> rest + noise.gaussian(0.1));
    }

    private void touch(Variables variables, String name, double max) {
        touched.put(name, 0.0);
        sensor(variables, name, 0, max, () -> touched.getOrDefault(name, 0.0));
    }

    private static void sensor(Variables variables, String name, double min, double max, DoubleSupplier reading) {
        Variable variable = new Variable(
                name + ".val", Value.of(min), () -> Value.of(Math.max(min, Math.min(max, reading.getAsDouble()))));
        variable.properties().range(min, max);
        variables.put(variable);
    }

    private double headCm(Map<String, Joint> joints) {
        double panDeg = degrees(joints, "headPan");
        double pitchDeg = degrees(joints, "neck") + degrees(joints, "headTilt");
        Point neck = body.pose().toWorld(NECK_AHEAD_MM, 0);
        double directionDeg = body.pose().toWorldDeg(panDeg);
        double seenMm =
                world.ray(body, neck.xMm(), neck.yMm(), directionDeg, FAR_MM).distanceMm() - NOSE_MM;
        double slope = Math.toRadians(pitchDeg);
        double floorMm = slope < 0 ? HEAD_HEIGHT_MM / Math.sin(-slope) : FAR_MM;
        return Math.min(seenMm / Math.max(0.1, Math.cos(slope)), floorMm) / 10;
    }

    private double chestCm() {
        Point chest = body.pose().toWorld(CHEST_AHEAD_MM, 0);
        double seenMm = world.ray(body, chest.xMm(), chest.yMm(), body.pose().headingDeg(), FAR_MM)
                .distanceMm();
        return Math.min(seenMm / 10, CHEST_FLOOR_CM);
    }

    private static double degrees(Map<String, Joint> joints, String name) {
        Joint joint = joints.get(name);
        return joint == null ? 0 : joint.degrees();
    }
}
