package majicsim.ros.message;

/** One field of a message type; {@code initial} is what a missing number means. */
record Field(String name, FieldType type, double initial) {}
