package majicsim.aibo.urbi;

/** First and second derivative of a number that is sampled once a cycle, in units per second and per second squared. */
final class Derivative {
    private double value = Double.NaN;
    private double speed;
    private double acceleration;

    void sample(double next, double seconds) {
        double newSpeed = Double.isNaN(value) ? 0 : (next - value) / seconds;
        acceleration = (newSpeed - speed) / seconds;
        speed = newSpeed;
        value = next;
    }

    double speed() {
        return speed;
    }

    double acceleration() {
        return acceleration;
    }
}
