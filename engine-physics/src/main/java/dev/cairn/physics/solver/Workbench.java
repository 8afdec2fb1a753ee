package dev.cairn.physics.solver;

/** What a worker has for itself while it solves: scratch, and helpers that hold state. */
final class Workbench {
    final Scratch scratch = new Scratch();
    final RowWindow row = new RowWindow();
    final RenewRow renew = new RenewRow();
    final Landing landing = new Landing();
    final Pivot pivot = new Pivot();
    final DirectSolve direct = new DirectSolve();
}
