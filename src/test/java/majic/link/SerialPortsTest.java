package majic.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Path;
import majic.link.SerialPorts.Port;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(value = OS.WINDOWS, disabledReason = "the folder of devices is that of Linux")
class SerialPortsTest {
    private static final String LEFTY = "usb-FTDI_FT232R_USB_UART_A50285BI-if00-port0";
    private static final String RIGHTY = "usb-FTDI_FT232R_USB_UART_A6004XYZ-if00-port0";
    private static final String SOCKET_1 = "pci-0000:00:14.0-usb-0:1:1.0-port0";
    private static final String SOCKET_2 = "pci-0000:00:14.0-usb-0:2:1.0-port0";

    @TempDir
    static Path folder;

    @AutoClose
    private final TestPorts ports = new TestPorts(folder);

    @Test
    void theNameWithTheSerialNumberIsPreferred() throws IOException {
        ports.plug("ttyUSB0", "A50285BI", LEFTY, SOCKET_1);

        Port port = ports.all().list().get(0);

        assertThat(port.name()).isEqualTo(ports.byId(LEFTY));
        assertThat(port.stays()).isTrue();
        assertThat(port).hasToString(ports.byId(LEFTY) + " – USB adapter, now " + ports.device("ttyUSB0"));
    }

    @Test
    void withoutASerialNumberTheNameOfTheSocketIsPreferred() throws IOException {
        ports.plug("ttyUSB0", "", "usb-1a86_USB_Serial-if00-port0", SOCKET_1);
        ports.plug("ttyUSB1", "", "usb-1a86_USB_Serial-if00-port0", SOCKET_2);

        assertThat(ports.all().list())
                .extracting(Port::name)
                .containsExactly(ports.byPath(SOCKET_1), ports.byPath(SOCKET_2));
    }

    @Test
    void aSerialNumberThatTwoAdaptersHaveIdentifiesNeither() throws IOException {
        ports.plug("ttyUSB0", "0001", "usb-Silicon_Labs_CP2102_0001-if00-port0", SOCKET_1);
        ports.plug("ttyUSB1", "0001", null, SOCKET_2);

        assertThat(ports.all().list())
                .extracting(Port::name)
                .containsExactly(ports.byPath(SOCKET_1), ports.byPath(SOCKET_2));
    }

    @Test
    void theFourPortsOfOneAdapterAreTold() throws IOException {
        ports.plug("ttyUSB0", "FT4X", "usb-FTDI_Quad_FT4X-if00-port0", SOCKET_1);
        ports.plug("ttyUSB1", "FT4X", "usb-FTDI_Quad_FT4X-if01-port0", SOCKET_2);

        assertThat(ports.all().list())
                .extracting(Port::name)
                .containsExactly(
                        ports.byId("usb-FTDI_Quad_FT4X-if00-port0"), ports.byId("usb-FTDI_Quad_FT4X-if01-port0"));
    }

    @Test
    void withoutLinksTheSerialNumberIsTheName() throws IOException {
        ports.plug("cu.usbserial-1410", "A50285BI", null, null);

        assertThat(ports.all().list()).extracting(Port::name).containsExactly("usb:A50285BI");
        assertThat(ports.all().find("usb:A50285BI").orElseThrow().device())
                .isEqualTo(ports.device("cu.usbserial-1410"));
    }

    @Test
    void allNamesOfAPortFindIt() throws IOException {
        ports.plug("ttyUSB3", "A50285BI", LEFTY, SOCKET_1);

        for (String name : new String[] {
            ports.device("ttyUSB3"), "ttyUSB3", ports.byId(LEFTY), ports.byPath(SOCKET_1), "usb:A50285BI"
        }) {
            assertThat(ports.all().find(name)).as(name).isPresent();
        }
        assertThat(ports.all().find("ttyUSB0")).isEmpty();
    }

    @Test
    void theNamesThatStayAreReadFromFiles() throws IOException {
        ports.plug("ttyUSB0", "A50285BI", LEFTY, SOCKET_1);
        ports.plug("ttyUSB1", "", "usb-1a86_USB_Serial-if00-port0", SOCKET_2);

        assertThat(ports.all().namesThatStay()).containsExactly(ports.byId(LEFTY), ports.byPath(SOCKET_2));
    }

    @Test
    void anAdapterIsFoundAgainUnderAnotherName() throws IOException {
        ports.plug("ttyUSB0", "A50285BI", LEFTY, SOCKET_1);
        ports.plug("ttyUSB1", "A6004XYZ", RIGHTY, SOCKET_2);
        SerialAddress address = opened("ttyUSB0");
        ports.unplugAll();
        ports.plug("ttyUSB0", "A6004XYZ", RIGHTY, SOCKET_2);
        ports.plug("ttyUSB1", "A50285BI", LEFTY, SOCKET_1);

        assertThat(address.find().device()).isEqualTo(ports.device("ttyUSB1"));
    }

    @Test
    void anotherAdapterUnderTheNameIsRefused() throws IOException {
        ports.plug("ttyUSB0", "A50285BI", LEFTY, SOCKET_1);
        SerialAddress address = opened("ttyUSB0");
        ports.unplugAll();
        ports.plug("ttyUSB0", "A6004XYZ", RIGHTY, SOCKET_1);

        assertThatThrownBy(address::find)
                .hasCauseInstanceOf(FileAlreadyExistsException.class)
                .hasMessage("the adapter that this robot had (" + LEFTY + ") is not plugged in; ttyUSB0 is another one"
                        + " now (" + RIGHTY + "); to use it all the same, add it \"as\" the robot's number");
    }

    @Test
    void anAdapterWithoutANumberMayBeAnotherOneIfThereWereSeveral() throws IOException {
        ports.plug("ttyUSB0", "", null, SOCKET_1);
        ports.plug("ttyUSB1", "", null, SOCKET_2);
        SerialAddress address = opened("ttyUSB0");
        ports.unplugAll();
        ports.plug("ttyUSB0", "", null, SOCKET_2);

        assertThatThrownBy(address::find)
                .hasCauseInstanceOf(FileAlreadyExistsException.class)
                .hasMessageStartingWith("ttyUSB0 may be another adapter now");
    }

    @Test
    void theOnlyAdapterOfItsKindIsTakenToBeTheSame() throws IOException {
        ports.plug("ttyUSB0", "", null, SOCKET_1);
        SerialAddress address = opened("ttyUSB0");
        ports.unplugAll();
        ports.plug("ttyUSB0", "", null, SOCKET_2);

        assertThat(address.find().device()).isEqualTo(ports.device("ttyUSB0"));
    }

    @Test
    void theNameOfASocketIsFollowedWithoutAsking() throws IOException {
        ports.plug("ttyUSB0", "", null, SOCKET_1);
        ports.plug("ttyUSB1", "", null, SOCKET_2);
        SerialAddress address = opened(ports.byPath(SOCKET_1));
        ports.unplugAll();
        ports.plug("ttyUSB0", "", null, SOCKET_2);
        ports.plug("ttyUSB1", "", null, SOCKET_1);

        assertThat(address.find().device()).isEqualTo(ports.device("ttyUSB1"));
    }

    @Test
    void aLinkThatTheSystemListsIsThePortToWhichItLeads() throws IOException {
        ports.plugUnknown("/dev/null", "ttyROBOT", LEFTY);

        Port port = ports.all().list().get(0);

        assertThat(ports.all().list()).hasSize(1);
        assertThat(port.name()).isEqualTo(ports.byId(LEFTY));
        assertThat(port.device()).isEqualTo("/dev/null");
    }

    @Test
    void numberedPortsOfUnknownAdaptersMayBeEachOthers() throws IOException {
        ports.plugUnknown("/dev/null", "ttyUSB0", null);
        ports.plugUnknown("/dev/zero", "ttyUSB1", null);
        SerialAddress address = opened("ttyUSB0");
        ports.unplugAll();
        ports.plugUnknown("/dev/zero", "ttyUSB0", null);

        assertThatThrownBy(address::find).hasMessageStartingWith("ttyUSB0 may be another adapter now");
    }

    private SerialAddress opened(String name) throws IOException {
        SerialAddress address = new SerialAddress(name, ports.all());
        address.opened(address.find());
        return address;
    }
}
