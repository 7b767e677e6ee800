package majic.bot;

/** A parameter that does not exist, may not be set so, or cannot hold the value given. Nothing was sent. */
public class ParameterException extends BotException {
    private static final long serialVersionUID = 1;

    private final String parameter;

    /**
     * A refused parameter.
     *
     * @param parameter its name as given
     * @param message the whole sentence
     */
    public ParameterException(String parameter, String message) {
        super(message);
        this.parameter = parameter;
    }

    /**
     * Returns the name of the parameter.
     *
     * @return the name as it was given
     */
    public String parameter() {
        return parameter;
    }
}
