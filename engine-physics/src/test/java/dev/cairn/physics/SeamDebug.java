package dev.cairn.physics;
class SeamDebug {
    public static void main(String[] a) {
        for (String kind : new String[] {"compound"}) {
            TileRuns.Start s = new TileRuns.Start(kind, .35, 5, .37, .2, 0, .1, .11, .23);
            double[] x = TileRuns.run(s, new TileRuns.Floor(0,0,0,0), 90, Scenes.awake().workers(1));
            double[] y = TileRuns.run(s, new TileRuns.Floor(.9,0,0,0), 90, Scenes.awake().workers(1));
            int shown = 0;
            for (int t = 0; t < 90 && shown < 12; t++) {
                double[] d = TileRuns.differences(java.util.Arrays.copyOfRange(x, 9*t, 9*t+9), java.util.Arrays.copyOfRange(y, 9*t, 9*t+9));
                if (d[0] > 1e-5 || d[4] > 2e-3) { shown++; System.out.println(kind + " " + t + " " + java.util.Arrays.toString(d) + " slab y " + x[9*t+1] + " w " + x[9*t+6]+","+x[9*t+7]+","+x[9*t+8]+ " tiles w " + y[9*t+6]+","+y[9*t+7]+","+y[9*t+8]); }
            }
        }
    }
}
