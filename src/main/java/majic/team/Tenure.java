package majic.team;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import majic.bot.BotException;
import majic.bot.MotionStopped;
import org.jspecify.annotations.Nullable;

/** The owner and the borrower of one robot. Guarded by the lock of the robot's {@link Member}. */
final class Tenure {
    private final int robot;
    private @Nullable Owner owner;
    private @Nullable Loan loan;

    /**
     * Creates the state without an owner.
     *
     * @param robot the robot's number
     */
    Tenure(int robot) {
        this.robot = robot;
    }

    /** The borrower, otherwise the owner; null if there is neither. */
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

    /** The loan, if it is to this borrower; null otherwise. */
    @Nullable
    Loan loanTo(@Nullable Owner somebody) {
        return loan != null && loan.isTo(somebody) ? loan : null;
    }

    /** The queues in which commands may wait: the robot's own, and while it is lent the borrower's. */
    List<CommandQueue> lanes(CommandQueue own) {
        return loan == null ? List.of(own) : List.of(own, loan.lane());
    }

    /**
     * Revokes the permission of owner and borrower to use the robot, except for the source of the stop.
     *
     * @return the owners to notify of it
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
     * Returns normally only if this source may move the robot now. The owner's own commands wait for their turn
     * while the robot is lent; those of all others are refused.
     *
     * @throws BotException if the robot has another owner
     * @throws MotionStopped if the source was ended or has given the robot back, and may not have been notified yet
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
     * Sets the owner.
     *
     * @throws BotException if the robot has another owner
     */
    void claim(Owner newOwner) {
        refuseOthers(newOwner);
        owner = newOwner;
    }

    /** Removes the owner; false if the robot is not owned by it. */
    boolean free(Owner oldOwner) {
        boolean his = owner == oldOwner;
        if (his) {
            owner = null;
        }
        return his;
    }

    /**
     * Begins a loan.
     *
     * @throws BotException if the robot has another owner, or is lent already
     */
    void lend(Loan begun, @Nullable Owner by) {
        Owner holder = holder();
        if (holder != null && (holder != by || loan != null)) {
            throw holder.inTheWay(robot);
        }
        loan = begun;
    }

    /** Ends a loan; null if the robot is not lent to this borrower. */
    @Nullable
    Loan takeBack(Owner from) {
        Loan ended = loanTo(from);
        if (ended != null) {
            loan = null;
        }
        return ended;
    }
}
