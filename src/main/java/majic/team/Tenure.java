package majic.team;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import org.jspecify.annotations.Nullable;

/** Who has one robot: its owner, and the one it is lent to. Guarded by the lock of the robot's {@link Member}. */
final class Tenure {
    private final int robot;
    private @Nullable Owner owner;
    private @Nullable Loan loan;

    /**
     * Nobody's.
     *
     * @param robot its number
     */
    Tenure(int robot) {
        this.robot = robot;
    }

    /** Who it is lent to, otherwise its owner; null if nobody has it. */
    @Nullable
    Owner holder() {
        return loan != null ? loan.to() : owner;
    }

    /** The owner of a robot that is lent; null if it is not lent, or has none. */
    @Nullable
    Owner lender() {
        return loan != null ? owner : null;
    }

    @Nullable
    Loan loan() {
        return loan;
    }

    /** The loan, if it is to him; null otherwise. */
    @Nullable
    Loan loanTo(@Nullable Owner somebody) {
        return loan != null && loan.isTo(somebody) ? loan : null;
    }

    /** In which orders may wait: the robot's own lane, and while it is lent the borrower's. */
    List<CommandQueue> lanes(CommandQueue own) {
        return loan == null ? List.of(own) : List.of(own, loan.lane());
    }

    /**
     * Takes the leave to order anything from owner and borrower, but for the one who says so.
     *
     * @return those who have to be told so
     */
    List<Owner> dismiss(@Nullable Owner by) {
        if (loan != null && !loan.isTo(by)) {
            loan.end(() -> new MotionStopped("stopped"));
        }
        List<Owner> dismissed = Stream.of(Optional.ofNullable(loan).map(Loan::to), Optional.ofNullable(owner))
                .flatMap(Optional::stream)
                .filter(holder -> holder != by)
                .toList();
        dismissed.forEach(Owner::dismiss);
        return dismissed;
    }

    /**
     * Goes on only for who may order it to move now. The owner's own orders wait for their turn while the robot is lent;
     * everybody else's are refused.
     *
     * @throws BotException if another one is in the way
     * @throws MotionStopped if he was ended or has given it back, and may not have heard of it yet
     */
    void check(@Nullable Owner by) {
        refuseOthers(by);
        boolean has = by == null || owner == by || loanTo(by) != null;
        if (!has || (by != null && by.isDismissed())) {
            throw new MotionStopped("stopped");
        }
    }

    private void refuseOthers(@Nullable Owner by) {
        if (loanTo(by) != null) {
            return;
        }
        Owner inTheWay = owner == null || owner != by ? holder() : null;
        if (inTheWay != null) {
            throw inTheWay.inTheWay(robot);
        }
    }

    /**
     * Becomes somebody's.
     *
     * @throws BotException if it is somebody else's
     */
    void claim(Owner newOwner) {
        refuseOthers(newOwner);
        owner = newOwner;
    }

    /** Is given back; false if it is not his. */
    boolean free(Owner oldOwner) {
        boolean his = owner == oldOwner;
        if (his) {
            owner = null;
        }
        return his;
    }

    /**
     * Is lent.
     *
     * @throws BotException if it is somebody else's, or lent already
     */
    void lend(Loan begun, @Nullable Owner by) {
        Owner holder = holder();
        if (holder != null && (holder != by || loan != null)) {
            throw holder.inTheWay(robot);
        }
        loan = begun;
    }

    /** Ends a loan; null if he has it not. */
    @Nullable
    Loan takeBack(Owner from) {
        Loan ended = loanTo(from);
        if (ended != null) {
            loan = null;
        }
        return ended;
    }
}
