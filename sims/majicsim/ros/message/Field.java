package majicsim.ros.message;

/** One field of a message type. */
record Field(String name, FieldType type) {}
