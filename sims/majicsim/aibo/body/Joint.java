package majicsim.aibo.body;

import majicsim.aibo.urbi.memory.Variable;
import majicsim.aibo.urbi.memory.Variables;
import majicsim.aibo.urbi.value.Value;

/**
 * A motor with its angle. The measured angle follows the command with a short lag; without power the angle stays, and
 * when switched on the motor holds that (URBI sheet, section 14).
 */
public final class Joint implements Variable.Hardware {
    /** The lag of a joint behind its command on the real server (capture E: 0.48 degrees at 40 degrees a second). */
    private static final double LAG_SEC = 0.012;

    private static final double RESOLUTION_DEG = 1e-4;

    private final JointType type;
    private final Variable angle;
    private final Variable proportional;
    private double measuredDeg;
    private double stiffness;

    public Joint(JointType type, Variables variables) {
        this.type = type;
        proportional = type.gains().install(variables, type.name());
        measuredDeg = type.restDeg();
        angle = new Variable(type.name() + ".val", Value.of(measuredDeg), this);
        angle.limit(type.minDeg(), type.maxDeg());
        Variable load = new Variable(type.name() + ".load", Value.of(0), new Variable.Hardware() {
            @Override
            public Value measure() {
                return Value.of(stiffness);
            }

            @Override
            public void command(double target) {
                stiffen(target);
            }
        });
        load.limit(0, 1);
        variables.put(angle);
        variables.put(load);
        variables.put(new Variable(type.name() + ".force", Value.of(0), () -> Value.of(force())));
    }

    JointType type() {
        return type;
    }

    public Variable angle() {
        return angle;
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

    /** Whether it does not move until its command, its stiffness or its gains change. */
    public boolean isAtRest() {
        return stiffness <= 0 || !(angle.target() instanceof Value.Num target) || target.number() == measuredDeg;
    }

    /** Moves the motor for a lab step. */
    public void step(double seconds) {
        if (stiffness <= 0 || !(angle.target() instanceof Value.Num target)) {
            return;
        }
        double error = target.number() - measuredDeg;
        if (Math.abs(error) < RESOLUTION_DEG) {
            measuredDeg = target.number();
            return;
        }
        double strength = strength();
        double limit = type.maxDegPerSec() * seconds * Math.min(1, strength);
        measuredDeg += Math.max(-limit, Math.min(limit, error * (1 - Math.exp(-seconds * strength / LAG_SEC))));
    }

    /** The motor's force: its lag times its stiffness. */
    double force() {
        return angle.target() instanceof Value.Num target ? stiffness * gain() * (target.number() - measuredDeg) : 0;
    }

    /** 1 for a stiff motor with its initial gain; a lower value follows more slowly. */
    private double strength() {
        return Math.max(0, stiffness * gain() / type.gains().proportional());
    }

    private double gain() {
        return proportional.target() instanceof Value.Num num ? num.number() : 0;
    }

    private void stiffen(double wanted) {
        boolean wasLoose = stiffness <= 0;
        stiffness = wanted;
        if (wasLoose && wanted > 0) {
            angle.write(Value.of(measuredDeg));
        }
    }
}
