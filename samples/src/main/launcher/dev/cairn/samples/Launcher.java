package dev.cairn.samples;

public final class Launcher {
    public static void main(String[] a) {
        System.out.println("hello " + System.getProperty("java.version"));
    }
}
