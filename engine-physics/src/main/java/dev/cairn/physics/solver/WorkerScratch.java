package dev.cairn.physics.solver;

import dev.cairn.physics.solver.direct.DirectSolve;
import dev.cairn.physics.solver.impact.ImpactStart;
import dev.cairn.physics.solver.impact.Impacts;
import dev.cairn.physics.solver.joint.AssemblyFlight;
import dev.cairn.physics.solver.joint.InnerMotion;
import dev.cairn.physics.solver.joint.JointSolve;
import dev.cairn.physics.solver.refresh.RefreshRow;
import dev.cairn.physics.solver.row.Scratch;
import dev.cairn.physics.solver.single.SingleBody;

/** What a worker has for itself while it solves: scratch, and helpers that hold state. */
final class WorkerScratch {
    final Scratch scratch = new Scratch();
    final RefreshRow renew = new RefreshRow();
    final SingleBody single = new SingleBody();
    final DirectSolve direct = new DirectSolve();
    final Impacts impacts = new Impacts();
    final ImpactStart start = new ImpactStart();
    final JointSolve joints = new JointSolve();
    final AssemblyFlight swing = new AssemblyFlight();
    final InnerMotion inner = new InnerMotion();

    /** Slots of the bodies of an island. */
    int[] island = {};
}
