package majicsim.aibo.urbi.syntax;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The name of a variable in a program: {@code x}, {@code dev.val}, {@code x[1]}, {@code $(text)}, with a suffix such as
 * {@code 'n}.
 *
 * @param text the name as written, with its dot if it has one; empty for a computed name
 * @param computed the expression inside {@code $( )}, null for a written name
 * @param index what stands in brackets behind it
 * @param suffix one of {@code 'n ' '' 'd 'dd 'e}, or empty
 */
public record Name(String text, @Nullable Expr computed, List<Expr> index, String suffix) {
    public static Name of(String text) {
        return new Name(text, null, List.of(), "");
    }

    public Name withSuffix(String added) {
        return new Name(text, computed, index, added);
    }

    Name with(List<Expr> keys) {
        return new Name(text, computed, keys, suffix);
    }
}
