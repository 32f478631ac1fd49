// Line protocol of `python -m tools.grade --command "java Adapter.java"`, for the functions of the class Student.
// Points are double[] {x, y}; no contact is null. Build: javac Adapter.java Student.java; run: java -cp . Adapter
// Delete the line of a function that you do not have.
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.util.Arrays;

class Adapter {
    static Object answer(String name, double[] a) {
        switch (name) {
            case "normalize_angle": return Student.normalize_angle(a[0]);
            case "add_angles": return Student.add_angles(a[0], a[1]);
            case "subtract_angles": return Student.subtract_angles(a[0], a[1]);
            case "min_difference": return Student.min_difference(a[0], a[1]);
            case "on_left": return Student.on_left(a[0], a[1]);
            case "to_polar": return Student.to_polar(point(a, 0));
            case "to_cartesian": return Student.to_cartesian(a[0], a[1]);
            case "closest_point_on_line": return Student.closest_point_on_line(point(a, 0), point(a, 2), point(a, 4));
            case "broad_phase_outcome": return Student.broad_phase_outcome(point(a, 0), a[2], a[3], a[4], a[5], a[6], a[7]);
            case "broad_phase":
                double[][] positions = new double[(a.length - 6) / 2][];
                for (int i = 0; i < positions.length; i++) positions[i] = point(a, 6 + 2 * i);
                return Student.broad_phase(point(a, 0), a[2], a[3], positions, a[4], a[5]);
            case "narrow_phase_case_1": return Student.narrow_phase_case_1(point(a, 0), a[2]);
            case "narrow_phase_case_2": return Student.narrow_phase_case_2(point(a, 0), a[2], a[3], a[4], a[5], a[6], a[7]);
            case "collision_response": return Student.collision_response(point(a, 0), point(a, 2), point(a, 4), a[6], a[7]);
            default: throw new UnsupportedOperationException(name);
        }
    }

    static double[] point(double[] a, int i) { return new double[] {a[i], a[i + 1]}; }

    static String text(Object result) {
        if (result instanceof double[]) return Arrays.toString((double[]) result);
        return result instanceof String ? "\"" + result + "\"" : String.valueOf(result);
    }

    public static void main(String[] unused) throws IOException {
        BufferedReader questions = new BufferedReader(new InputStreamReader(System.in));
        for (String line; (line = questions.readLine()) != null;) { // {"function": "to_polar", "arguments": [3.0, 4.0]}
            String name = line.split("\"")[3];
            String[] numbers = line.substring(line.indexOf('[') + 1, line.indexOf(']')).split(", ");
            try {
                double[] arguments = Arrays.stream(numbers).mapToDouble(Double::parseDouble).toArray();
                System.out.println("{\"result\": " + text(answer(name, arguments)) + "}");
            } catch (UnsupportedOperationException missing) {
                System.out.println("{\"undefined\": true}");
            } catch (RuntimeException error) {
                System.out.println("{\"error\": \"" + error.toString().replaceAll("[\"\\\\\n]", " ") + "\"}");
            }
        }
    }
}
