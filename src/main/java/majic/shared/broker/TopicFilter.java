package majic.shared.broker;

/** Which topics a subscription is for, by the rules of MQTT. */
final class TopicFilter {
    private final String[] levels;
    private final boolean wildcards;

    /**
     * Reads a filter.
     *
     * @throws IllegalArgumentException if a wildcard is not a level of its own, or # is not the last one
     */
    TopicFilter(String filter) {
        levels = filter.split("/", -1);
        wildcards = filter.contains("#") || filter.contains("+");
        for (int i = 0; i < levels.length; i++) {
            boolean wildcard = levels[i].contains("#") || levels[i].contains("+");
            if (wildcard && (levels[i].length() > 1 || levels[i].equals("#") && i < levels.length - 1)) {
                throw new IllegalArgumentException("not a filter of topics: " + filter);
            }
        }
    }

    /** Returns whether it is for more than one topic. */
    boolean hasWildcards() {
        return wildcards;
    }

    boolean matches(String topic) {
        if (topic.startsWith("$") && !levels[0].startsWith("$")) {
            return false;
        }
        int at = 0;
        for (String level : levels) {
            if (level.equals("#")) {
                return true;
            }
            if (at > topic.length()) {
                return false;
            }
            int slash = topic.indexOf('/', at);
            int end = slash < 0 ? topic.length() : slash;
            if (!level.equals("+") && !isAt(level, topic, at, end)) {
                return false;
            }
            at = end + 1;
        }
        return at > topic.length();
    }

    private static boolean isAt(String level, String topic, int from, int end) {
        return level.length() == end - from && topic.startsWith(level, from);
    }
}
