package majicsim.aibo.body;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleSupplier;
import majicsim.aibo.scene.Scene;
import majicsim.aibo.scene.Vector;
import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.value.Value;
import majicsim.world.Body;
import majicsim.world.Noise;
import majicsim.world.Point;
import majicsim.world.World;

/** The dog's sensors (URBI sheet, section 13): distances from the room, the rest from its own state. */
public final class Sensors {
    private static final double GRAVITY = 9.80665;
    private static final double CHEST_AHEAD_MM = 100;
    /** The chest sensor faces the floor in front of the feet: without a wall it measures the floor. */
    private static final double CHEST_FLOOR_CM = 40;

    private static final double DISTANCE_SPREAD = 0.02;
    private static final double FAR_MM = 2000;
    private static final double RESTING_JOLT = 0.1;
    private static final double WALKING_JOLT = 1;

    private final World world;
    private final Body body;
    private final Head head;
    private final BodyOrientation orientation;
    private final Gait gait;
    private final Noise noise;
    private final Map<String, Double> pressed = new LinkedHashMap<>();

    public Sensors(World world, Body body, Head head, BodyOrientation orientation, Gait gait, Noise noise) {
        this.world = world;
        this.body = body;
        this.head = head;
        this.orientation = orientation;
        this.gait = gait;
        this.noise = noise;
    }

    /** Makes the variables of all sensors. */
    public void install(Variables variables) {
        distance(variables, "distanceNear", 5.7, 50, this::headCm);
        distance(variables, "distance", 20, 150, this::headCm);
        variables.rename("distanceFar", "distance");
        distance(variables, "distanceChest", 19, 90, this::chestCm);
        acceleration(variables, "accelX", () -> gravity().x());
        acceleration(variables, "accelY", () -> gravity().y());
        acceleration(variables, "accelZ", () -> gravity().z());
        for (String paw : List.of("pawLF", "pawLH", "pawRF", "pawRH")) {
            pressed.put(paw, 0.0);
            sensor(variables, paw, 0, 1, () -> orientation.isOnGround(paw.substring(3)) ? 1 : pressed(paw));
        }
        touch(variables, "chinSensor", 1);
        touch(variables, "headSensor", 35);
        touch(variables, "backSensorF", 60);
        touch(variables, "backSensorM", 60);
        touch(variables, "backSensorR", 60);
        touch(variables, "WIFIswitch", 1);
    }

    /** Sets the reading of a touch sensor, in its own unit. */
    public void touch(String sensor, double value) {
        if (!pressed.containsKey(sensor)) {
            throw new IllegalArgumentException("no touch sensor " + sensor + ", only " + pressed.keySet());
        }
        pressed.put(sensor, value);
    }

    private void distance(Variables variables, String name, double minCm, double maxCm, DoubleSupplier cm) {
        sensor(variables, name, minCm, maxCm, () -> cm.getAsDouble() * noise.scale(DISTANCE_SPREAD));
    }

    private void acceleration(Variables variables, String name, DoubleSupplier rest) {
        sensor(variables, name, -2 * GRAVITY, 2 * GRAVITY, () -> rest.getAsDouble() + noise.gaussian(jolt()));
    }

    /** The acceleration by gravity in the body's own frame: g downwards when it stands. */
    private Vector gravity() {
        return new Vector(0, 0, -GRAVITY)
                .pitched(-orientation.shoulders().pitchDeg())
                .rolled(-orientation.rollDeg());
    }

    private double jolt() {
        return gait.isWalking() ? WALKING_JOLT : RESTING_JOLT;
    }

    private void touch(Variables variables, String name, double max) {
        pressed.put(name, 0.0);
        sensor(variables, name, 0, max, () -> pressed(name));
    }

    private double pressed(String name) {
        return pressed.getOrDefault(name, 0.0);
    }

    private static void sensor(Variables variables, String name, double min, double max, DoubleSupplier reading) {
        Variable variable = new Variable(
                name + ".val", Value.of(min), () -> Value.of(Math.max(min, Math.min(max, reading.getAsDouble()))));
        variable.limit(min, max);
        variables.put(variable);
    }

    private double headCm() {
        return Scene.distanceMm(world, body, head.view()) / 10;
    }

    private double chestCm() {
        Point chest = body.pose().toWorld(CHEST_AHEAD_MM, 0);
        double seenMm = world.ray(body, chest.xMm(), chest.yMm(), body.pose().headingDeg(), FAR_MM)
                .distanceMm();
        return Math.min(seenMm / 10, CHEST_FLOOR_CM);
    }
}
