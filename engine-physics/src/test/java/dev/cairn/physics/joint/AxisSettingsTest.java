package dev.cairn.physics.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

import java.lang.reflect.Field;
import java.lang.reflect.Modifier;

/** All settings of an axis become numbers and come back: no field is left out. */
class AxisSettingsTest {
    @Test
    void everyFieldComesBack() throws Exception {
        int fields = 0;
        for (Field field : AxisSettings.class.getDeclaredFields()) {
            if (Modifier.isStatic(field.getModifiers())) {
                continue;
            }
            fields++;
            AxisSettings from = new AxisSettings();
            boolean isFlag = field.getType() == boolean.class;
            field.set(from, isFlag ? (Object) true : (Object) 2.5);
            double[] numbers = new double[AxisSettings.NUMBERS];
            from.exchange(numbers, 0, false);
            AxisSettings to = new AxisSettings();
            to.exchange(numbers, 0, true);
            assertEquals(field.get(from), field.get(to), field.getName());
        }
        assertEquals(AxisSettings.NUMBERS, fields, "numbers that AxisSettings.exchange uses");
    }
}
