package dev.cairn.physics.joint;

import org.joml.Vector3d;
import org.jspecify.annotations.Nullable;

/**
 * Where a joint was put when it was made, world; {@link JointRef#madeAt} tells it.
 *
 * @param anchorA point of A, m, or null if none was given: the centre of mass
 * @param anchorB point of B, m, or null if none was given
 * @param axis x axis of the frames, of length 1
 * @param secondAxis what was given for their y axis, of length 1, or null if nothing was
 */
public record JointPlace(
        @Nullable Vector3d anchorA,
        @Nullable Vector3d anchorB,
        Vector3d axis,
        @Nullable Vector3d secondAxis) {}
