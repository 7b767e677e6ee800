package majic.act;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;
import majic.bot.Unit;

/**
 * Marks a field of an act as an argument, which may be given when the act is run: {@code 2 act Wander speed=200}. The
 * name of the field is the name of the argument, and the value that the constructor gives it is the default.
 *
 * <p>The field is a {@code double}, {@code int}, {@code boolean} or {@code String}, and neither static, final nor
 * transient. It is set before the act starts, on another thread than that of the act.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.FIELD)
public @interface Argument {
    /** Returns what the argument is for: a phrase without a full stop, such as {@code how fast it drives}. */
    String value();

    /** Returns the unit of a number; a number given without unit is in it. */
    Unit unit() default Unit.NONE;

    /** Returns the lowest number that is accepted, in the unit. */
    double from() default -Double.MAX_VALUE;

    /** Returns the highest number that is accepted, in the unit. */
    double to() default Double.MAX_VALUE;

    /** Returns the words that a {@code String} may be; without them it may be any text. */
    String[] choices() default {};
}
