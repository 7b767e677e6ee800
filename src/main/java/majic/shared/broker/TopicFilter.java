package majic.shared.broker;

/** Which topics a subscription is for, by the rules of MQTT. */
final class TopicFilter {
    private final String[] levels;

    /**
     * Reads a filter.
     *
     * @throws IllegalArgumentException if a wildcard is not a level of its own, or # is not the last one
     */
    TopicFilter(String filter) {
        levels = filter.split("/", -1);
        for (int i = 0; i < levels.length; i++) {
            boolean wildcard = levels[i].contains("#") || levels[i].contains("+");
            if (wildcard && (levels[i].length() > 1 || levels[i].equals("#") && i < levels.length - 1)) {
                throw new IllegalArgumentException("not a filter of topics: " + filter);
            }
        }
    }

    boolean matches(String topic) {
        String[] given = topic.split("/", -1);
        if (topic.startsWith("$") && !levels[0].equals(given[0])) {
            return false;
        }
        for (int i = 0; i < levels.length; i++) {
            if (levels[i].equals("#")) {
                return true;
            }
            if (i >= given.length || !levels[i].equals("+") && !levels[i].equals(given[i])) {
                return false;
            }
        }
        return levels.length == given.length;
    }
}
