package majicsim.aibo.urbi.memory;

/** First and second derivative of a number that is sampled once a cycle, in units per second and per second squared. */
public final class Derivative {
    private double value = Double.NaN;
    private double speed;
    private double acceleration;

    void sample(double next, double seconds) {
        double newSpeed = Double.isNaN(value) ? 0 : (next - value) / seconds;
        acceleration = (newSpeed - speed) / seconds;
        speed = newSpeed;
        value = next;
    }

    public double speed() {
        return speed;
    }

    public double acceleration() {
        return acceleration;
    }
}
