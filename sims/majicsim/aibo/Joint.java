package majicsim.aibo;

/**
 * A motor with its angle. The measured angle runs after the command with a short lag; loose it stays where it is, and switched on it
 * holds that (URBI sheet, section 14).
 */
final class Joint implements Variable.Hardware {
    /** So far behind its command a joint ran on the real server (capture E: 0.48 degrees at 40 degrees a second). */
    private static final double LAG_SEC = 0.012;

    private static final double MAX_DEG_PER_SEC = 360;
    private static final double RESOLUTION_DEG = 1e-4;

    private final JointType type;
    private final Variable angle;
    private final Variable load;
    private double measuredDeg;
    private double stiffness;

    Joint(JointType type) {
        this.type = type;
        measuredDeg = type.restDeg();
        angle = new Variable(type.name() + ".val", Value.of(measuredDeg), this);
        angle.properties().range(type.minDeg(), type.maxDeg());
        load = new Variable(type.name() + ".load", Value.of(0), new Variable.Hardware() {
            @Override
            public Value measure() {
                return Value.of(stiffness);
            }

            @Override
            public void command(double target) {
                stiffen(target);
            }
        });
        load.properties().range(0, 1);
    }

    JointType type() {
        return type;
    }

    Variable angle() {
        return angle;
    }

    Variable load() {
        return load;
    }

    double degrees() {
        return measuredDeg;
    }

    double stiffness() {
        return stiffness;
    }

    @Override
    public Value measure() {
        return Value.of(measuredDeg);
    }

    @Override
    public boolean moves() {
        return true;
    }

    /** Lets the motor work for a lab step. */
    void step(double seconds) {
        if (stiffness <= 0 || !(angle.target() instanceof Value.Num target)) {
            return;
        }
        double error = target.number() - measuredDeg;
        if (Math.abs(error) < RESOLUTION_DEG) {
            measuredDeg = target.number();
            return;
        }
        double limit = MAX_DEG_PER_SEC * seconds;
        measuredDeg += Math.max(-limit, Math.min(limit, error * (1 - Math.exp(-seconds / LAG_SEC))));
    }

    private void stiffen(double wanted) {
        boolean wasLoose = stiffness <= 0;
        stiffness = wanted;
        if (wasLoose && wanted > 0) {
            angle.write(Value.of(measuredDeg));
        }
    }
}
