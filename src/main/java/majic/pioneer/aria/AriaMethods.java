package majic.pioneer.aria;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.List;
import java.util.Map;

/** The methods of ARIA's robot without which none can be driven, by their descriptors in class files. */
final class AriaMethods {
    private static final Map<String, List<String>> NAMES = Map.of(
            "()I", List.of("tryLock", "unlock", "getFlags", "getStallValue", "getNumSonar"),
            "()Z", List.of("blockingConnect", "isConnected"),
            "()V", List.of("stop", "enableMotors", "disableMotors"),
            "(Z)V", List.of("runAsync", "stopRunning"),
            "(D)V",
                    List.of(
                            "setVel",
                            "setRotVel",
                            "setTransVelMax",
                            "setTransAccel",
                            "setTransDecel",
                            "setRotVelMax",
                            "setRotAccel",
                            "setRotDecel"),
            "()D", List.of("getX", "getY", "getTh", "getLeftVel", "getRightVel", "getRotVel", "getBatteryVoltageNow"),
            "(I)I", List.of("getSonarRange"),
            "(S)Z", List.of("com"),
            "(SS)Z", List.of("comInt"),
            "(Lcom/mobilerobots/Aria/ArDeviceConnection;)V", List.of("setDeviceConnection"));

    private AriaMethods() {}

    /**
     * Looks for the methods before any of them is needed: a robot must not start to move by an ARIA that cannot stop
     * it.
     *
     * @throws NoSuchMethodException naming the first one that is missing, or has other parameters or another result
     */
    static void check(Class<?> robot) throws NoSuchMethodException {
        for (Map.Entry<String, List<String>> names : NAMES.entrySet()) {
            MethodType type = MethodType.fromMethodDescriptorString(names.getKey(), robot.getClassLoader());
            for (String name : names.getValue()) {
                find(robot, name, type);
            }
        }
    }

    private static void find(Class<?> robot, String name, MethodType type) throws NoSuchMethodException {
        try {
            MethodHandles.publicLookup().findVirtual(robot, name, type);
        } catch (IllegalAccessException e) {
            throw new NoSuchMethodException(robot.getName() + "." + name + type + " is not public");
        }
    }
}
