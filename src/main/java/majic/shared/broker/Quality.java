package majic.shared.broker;

/** The quality of service of a message, as MQTT defines it. */
public enum Quality {
    /** Sent once and not acknowledged: a message can be lost (quality of service 0). */
    AT_MOST_ONCE,
    /** Sent until it is acknowledged: a message can arrive twice (quality of service 1). */
    AT_LEAST_ONCE
}
