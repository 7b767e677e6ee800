package majicsim.aibo.urbi.syntax;

/** From the first to the last character of a piece of program text, printed the way the kernel prints positions. */
record Span(Place first, Place last) {
    @Override
    public String toString() {
        String start = first.line() + "." + first.column();
        if (first.equals(last)) {
            return start;
        }
        return first.line() == last.line()
                ? start + "-" + last.column()
                : start + "-" + last.line() + "." + last.column();
    }
}
