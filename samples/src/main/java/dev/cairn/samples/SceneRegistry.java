package dev.cairn.samples;

import dev.cairn.samples.scenes.BigOnSmall;
import dev.cairn.samples.scenes.BouncingBall;
import dev.cairn.samples.scenes.Carried;
import dev.cairn.samples.scenes.Conveyor;
import dev.cairn.samples.scenes.Cradle;
import dev.cairn.samples.scenes.CubesOnPlane;
import dev.cairn.samples.scenes.Dzhanibekov;
import dev.cairn.samples.scenes.FreeFall;
import dev.cairn.samples.scenes.FrictionStop;
import dev.cairn.samples.scenes.LargeWorld;
import dev.cairn.samples.scenes.LoadRemoval;
import dev.cairn.samples.scenes.ObjDrop;
import dev.cairn.samples.scenes.OneWay;
import dev.cairn.samples.scenes.Pairs;
import dev.cairn.samples.scenes.RollingLoad;
import dev.cairn.samples.scenes.RollingResistance;
import dev.cairn.samples.scenes.Shafts;
import dev.cairn.samples.scenes.Shapes;
import dev.cairn.samples.scenes.SlipToRoll;
import dev.cairn.samples.scenes.SlopeBall;
import dev.cairn.samples.scenes.SlopeBox;
import dev.cairn.samples.scenes.SphereGrid;
import dev.cairn.samples.scenes.StaticCubes;
import dev.cairn.samples.scenes.heap.BoxPit;
import dev.cairn.samples.scenes.heap.CompoundPile;
import dev.cairn.samples.scenes.heap.Pile;
import dev.cairn.samples.scenes.heap.Room;
import dev.cairn.samples.scenes.heap.Tumble;
import dev.cairn.samples.scenes.heap.Washer;
import dev.cairn.samples.scenes.joint.Car;
import dev.cairn.samples.scenes.joint.Chains;
import dev.cairn.samples.scenes.joint.Machines;
import dev.cairn.samples.scenes.joint.Mechanisms;
import dev.cairn.samples.scenes.joint.Nets;
import dev.cairn.samples.scenes.joint.Pendulums;
import dev.cairn.samples.scenes.joint.Ragdolls;
import dev.cairn.samples.scenes.joint.Tautochrone;
import dev.cairn.samples.scenes.level.Bowl;
import dev.cairn.samples.scenes.level.Funnel;
import dev.cairn.samples.scenes.level.Hills;
import dev.cairn.samples.scenes.level.House;
import dev.cairn.samples.scenes.seam.BrickWall;
import dev.cairn.samples.scenes.seam.BulletStack;
import dev.cairn.samples.scenes.seam.Bullets;
import dev.cairn.samples.scenes.seam.Gas;
import dev.cairn.samples.scenes.seam.NearMiss;
import dev.cairn.samples.scenes.seam.SpinningRod;
import dev.cairn.samples.scenes.seam.Tiles;
import dev.cairn.samples.scenes.stack.Arch;
import dev.cairn.samples.scenes.stack.Cards;
import dev.cairn.samples.scenes.stack.ManyPyramids;
import dev.cairn.samples.scenes.stack.Overhang;
import dev.cairn.samples.scenes.stack.Pyramid;
import dev.cairn.samples.scenes.stack.StackOfBoxes;
import dev.cairn.samples.scenes.water.Floating;

import java.util.List;

/** All scenes, in the order of lists and number keys. Stateless. */
public final class SceneRegistry {
    private static final List<SampleScene> SCENES =
            List.of(
                    SlopeBox.scene(),
                    StackOfBoxes.scene(),
                    SlopeBall.scene(),
                    Room.scene(),
                    StaticCubes.scene(),
                    CubesOnPlane.scene(),
                    Pairs.scene(),
                    ObjDrop.scene(),
                    Pyramid.scene(),
                    FreeFall.scene(),
                    BouncingBall.scene(),
                    Tumble.scene(),
                    RollingLoad.scene(),
                    SphereGrid.bouncing(),
                    SphereGrid.inelastic(),
                    SphereGrid.elastic(),
                    ManyPyramids.scene(),
                    LargeWorld.scene(),
                    Shafts.scene(),
                    Pile.spheres(),
                    Pile.boxes(),
                    Pile.mixed(),
                    Pile.rounds(),
                    Pile.hulls(),
                    Pile.junkyard(),
                    CompoundPile.scene(),
                    OneWay.scene(),
                    Conveyor.scene(),
                    Washer.scene(),
                    StackOfBoxes.tall(),
                    StackOfBoxes.massRatio(),
                    LoadRemoval.scene(),
                    BigOnSmall.scene(),
                    BoxPit.scene(),
                    Arch.scene(),
                    Overhang.scene(),
                    Cards.scene(),
                    Dzhanibekov.scene(),
                    Cradle.scene(),
                    SlipToRoll.scene(),
                    FrictionStop.scene(),
                    RollingResistance.scene(),
                    Shapes.scene(),
                    Carried.platform(),
                    Carried.lift(),
                    Carried.turntable(),
                    Floating.scene(),
                    Pendulums.single(),
                    Pendulums.twofold(),
                    Tautochrone.scene(),
                    Chains.heavy(),
                    Chains.plain(),
                    Nets.bridge(),
                    Nets.grid(),
                    Ragdolls.scene(),
                    Machines.gears(),
                    Machines.cradle(),
                    Machines.fallingRod(),
                    Mechanisms.door(),
                    Mechanisms.sliderCrank(),
                    Mechanisms.fourBar(),
                    Mechanisms.robotArm(),
                    Car.scene(),
                    Bowl.scene(),
                    House.scene(),
                    Hills.terrain(),
                    Hills.meshDrop(),
                    Funnel.scene(),
                    Tiles.scene(),
                    Bullets.scene(),
                    NearMiss.scene(),
                    SpinningRod.scene(),
                    Gas.scene(),
                    BulletStack.scene(),
                    BrickWall.scene());

    /** Scenes of the report of 2020, which come first, and the pyramid. */
    private static final int REPORTED = 9;

    /** What {@code --scene} takes beside ids: all scenes, and those of the report. */
    public static final String ALL = "all", REPORT = "report";

    private SceneRegistry() {}

    /**
     * All scenes.
     *
     * @return an immutable list
     */
    public static List<SampleScene> all() {
        return SCENES;
    }

    /**
     * The scenes that run without a window if none is named: a minute with pictures.
     *
     * @return an immutable list
     */
    public static List<SampleScene> report() {
        return SCENES.subList(0, REPORTED);
    }

    /**
     * The ids of all scenes.
     *
     * @return an immutable list, in the same order
     */
    public static List<String> ids() {
        return SCENES.stream().map(SampleScene::id).toList();
    }

    /**
     * Finds a scene.
     *
     * @param id its id
     * @return the scene
     * @throws UsageException if there is none of this id; the message suggests the nearest
     */
    public static SampleScene get(String id) {
        for (SampleScene scene : SCENES) {
            if (scene.id().equals(id)) {
                return scene;
            }
        }
        throw new UsageException(
                "--scene %s: there is no such scene%s; --list shows all"
                        .formatted(id, Nearest.hint(id, ids())));
    }
}
